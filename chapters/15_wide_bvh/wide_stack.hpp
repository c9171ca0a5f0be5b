// Lesson 15, step 5: the children that wait, and in which order.
#pragma once
#include "chapters/14_bvh/build.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

namespace course {

// At most seven children wait on each level, and a push may write eight.
inline constexpr unsigned most_waiting = 7 * deepest + lanes;

// The children that wait. How many there are is the walk's to know, in a register: a push takes the number and returns
// the new one.
class WideLinks {
  public:
    WideLink operator[](unsigned i) const { return links_[i]; }

    // Those of the eight lanes whose bits are set.
    unsigned push(unsigned waiting, Ints links, unsigned bits) {
        store(links_ + waiting, compressed(links, bits));
        return waiting + static_cast<unsigned>(std::popcount(bits));
    }

  private:
    WideLink links_[most_waiting];
};

// The same with the distances at which the ray enters them.
class WideStack {
  public:
    WideLink operator[](unsigned i) const { return links_[i]; }

    unsigned push(unsigned waiting, WideLink link, float enter) {
        links_[waiting] = link;
        enters_[waiting] = enter;
        return waiting + 1;
    }
    // Those of the eight lanes whose bits are set, the first at the bottom.
    unsigned push(unsigned waiting, Ints links, Floats enter, unsigned bits) {
        store(links_ + waiting, compressed(links, bits));
        store(enters_ + waiting, compressed(enter, bits));
        return waiting + static_cast<unsigned>(std::popcount(bits));
    }
    // Takes out what begins beyond t_max. Returns how many are left; their order stays.
    unsigned drop_beyond(unsigned waiting, float t_max) {
        unsigned left = 0;
        for (unsigned i = 0; i < waiting; i += lanes) {
            const unsigned here = waiting - i < lanes ? (1u << (waiting - i)) - 1 : 255;
            const auto enters = load(enters_ + i);
            left = push(left, load<Ints>(links_ + i), enters, ~above(enters, all(t_max)) & here);
        }
        return left;
    }

  private:
    float enters_[most_waiting];
    WideLink links_[most_waiting];
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
template <class Entries> [[gnu::always_inline]] inline unsigned
push_by_octant(WideStack &stack, unsigned waiting, const WideNode &node, unsigned octant, const Entries &entries) {
    const Ints order = unpacked(node.far_first[octant]);
    const Entries ordered{permuted(entries.enter, order), permuted(entries.exit, order)};
    return stack.push(waiting, permuted(load<Ints>(node.links), order), ordered.enter, ordered.met());
}

template <WideOptions Options, class Entries> [[gnu::always_inline]] inline unsigned
push(WideStack &stack, unsigned waiting, const WideNode &node, unsigned octant, const Entries &entries) {
    if constexpr (Options.order == WideOptions::Order::octant)
        return push_by_octant(stack, waiting, node, octant, entries);
    else
        return push_by_distance(stack, waiting, node, entries.enter, entries.met());
}

} // namespace course
