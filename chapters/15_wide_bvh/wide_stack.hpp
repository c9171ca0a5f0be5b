// Lesson 15, step 5: the children that wait, and in which order.
#pragma once
#include "chapters/14_bvh/build.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

namespace course {

// Beyond the end, which waits longest: on each level at most seven children, twice as many if two nodes are opened at a
// time, and a push may write eight.
inline constexpr unsigned most_waiting = 1 + 2 * (7 * deepest + lanes);

// The children that wait. How many there are is the walk's to know, in a register: a push takes the number and returns
// the new one.
class WideLinks {
  public:
    WideLink operator[](unsigned i) const { return links_[i]; }

    unsigned push(unsigned waiting, WideLink link) {
        links_[waiting] = link;
        return waiting + 1;
    }
    // Those of the eight lanes whose bits are set, the first at the bottom.
    unsigned push(unsigned waiting, Ints links, unsigned bits) {
        store(links_ + waiting, compressed(links, bits));
        return waiting + static_cast<unsigned>(std::popcount(bits));
    }

  protected:
    Ints eight_from(unsigned i) const { return load<Ints>(links_ + i); }

  private:
    alignas(64) WideLink links_[most_waiting]; // the first of them, which are often used, in one cache line
};

// The same with the distances at which the ray enters them.
class WideStack : public WideLinks {
  public:
    using WideLinks::push; // without distances

    unsigned push(unsigned waiting, WideLink link, float enter) {
        enters_[waiting] = enter;
        return push(waiting, link);
    }
    unsigned push(unsigned waiting, Ints links, Floats enter, unsigned bits) {
        store(enters_ + waiting, compressed(enter, bits));
        return push(waiting, links, bits);
    }
    // Takes out what begins beyond t_max. Returns how many are left; their order stays.
    unsigned drop_beyond(unsigned waiting, float t_max) {
        unsigned left = 0;
        for (unsigned i = 0; i < waiting; i += lanes) {
            const unsigned here = waiting - i < lanes ? (1u << (waiting - i)) - 1 : 255;
            const auto enters = load(enters_ + i);
            left = push(left, eight_from(i), enters, ~above(enters, all(t_max)) & here);
        }
        return left;
    }

  private:
    alignas(64) float enters_[most_waiting];
};

// The children that the ray meets, by the distance at which it enters them: one after the other finds its place among
// those of this node.
inline unsigned push_by_distance(WideStack &stack, unsigned waiting, const WideNode &node, Floats enter, unsigned met) {
    WideLink links[lanes];
    float enters[lanes], all_enters[lanes];
    store(all_enters, enter);
    unsigned count = 0;
    for (; met; met &= met - 1, ++count) {
        const unsigned child = lowest(met);
        unsigned place = count;
        for (; place > 0 && enters[place - 1] < all_enters[child]; --place) {
            enters[place] = enters[place - 1];
            links[place] = links[place - 1];
        }
        enters[place] = all_enters[child];
        links[place] = node.links[child];
    }
    for (unsigned i = 0; i < count; ++i)
        waiting = stack.push(waiting, links[i], enters[i]);
    return waiting;
}

// The children that the ray meets, the far ones first as the node lists them: no comparison and no branch.
template <class Entries> [[gnu::always_inline]] inline unsigned push_by_octant(WideStack &stack, unsigned waiting,
                                                                               const WideNode &node, unsigned octant,
                                                                               const Entries &entries, unsigned of) {
    const Ints order = unpacked(node.far_first[octant]);
    const Entries ordered{permuted(entries.enter, order), permuted(entries.exit, order)};
    return stack.push(waiting, permuted(load<Ints>(node.links), order), ordered.enter, ordered.met() & of);
}

// Of the children whose bits are set in `of`, those that the ray meets: all or none, if they are in the octant's order.
template <WideOptions Options, class Entries>
[[gnu::always_inline]] inline unsigned push(WideStack &stack, unsigned waiting, const WideNode &node, unsigned octant,
                                            const Entries &entries, unsigned of = all_children) {
    if constexpr (Options.order == WideOptions::Order::octant)
        return push_by_octant(stack, waiting, node, octant, entries, of);
    else
        return push_by_distance(stack, waiting, node, entries.enter, entries.met() & of);
}

} // namespace course
