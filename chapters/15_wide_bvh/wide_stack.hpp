// Lesson 15, step 5: the children that wait, and in which order.
#pragma once
#include "chapters/14_bvh/build.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

namespace course {

// At most seven children wait on each level, and a push may write eight.
inline constexpr unsigned most_waiting = 7 * deepest + lanes;

// The children that wait.
class WideLinks {
  public:
    // Those of the eight lanes whose bits are set.
    void push(Ints links, unsigned bits) {
        store(links_ + waiting_, compressed(links, bits));
        waiting_ += static_cast<unsigned>(std::popcount(bits));
    }
    bool pop(WideLink &link) {
        if (waiting_ == 0)
            return false;
        link = links_[--waiting_];
        return true;
    }

  private:
    unsigned waiting_ = 0;
    WideLink links_[most_waiting];
};

// The same with the distances at which the ray enters them.
class WideStack {
  public:
    void push(WideLink link, float enter) {
        links_[waiting_] = link;
        enters_[waiting_] = enter;
        ++waiting_;
    }
    // Those of the eight lanes whose bits are set, the first at the bottom.
    void push(Ints links, Floats enter, unsigned bits) {
        store(links_ + waiting_, compressed(links, bits));
        store(enters_ + waiting_, compressed(enter, bits));
        waiting_ += static_cast<unsigned>(std::popcount(bits));
    }
    // Takes the last one that begins by t_max into `link`, and drops those after it. False if there is none.
    bool pop(WideLink &link, float t_max) {
        while (waiting_ != 0) {
            --waiting_;
            if (!(enters_[waiting_] > t_max)) {
                link = links_[waiting_];
                return true;
            }
        }
        return false;
    }
    void clear() { waiting_ = 0; }

  private:
    unsigned waiting_ = 0;
    float enters_[most_waiting];
    WideLink links_[most_waiting];
};

// The children that the ray meets, by the distance at which it enters them: one after the other finds its place among
// those of this node.
inline void push_by_distance(WideStack &stack, const WideNode &node, Floats enter, unsigned met) {
    WideLink links[lanes];
    float enters[lanes], all_enters[lanes];
    store(all_enters, enter);
    unsigned count = 0;
    for (; met; met &= met - 1, ++count) {
        const auto child = static_cast<unsigned>(std::countr_zero(met));
        unsigned place = count;
        for (; place > 0 && enters[place - 1] < all_enters[child]; --place) {
            enters[place] = enters[place - 1];
            links[place] = links[place - 1];
        }
        enters[place] = all_enters[child];
        links[place] = node.links[child];
    }
    for (unsigned i = 0; i < count; ++i)
        stack.push(links[i], enters[i]);
}

// The children that the ray meets, the far ones first as the node lists them: no comparison and no branch.
inline void push_by_octant(WideStack &stack, const WideNode &node, unsigned octant, Floats enter, unsigned met) {
    const Ints order = unpacked(node.far_first[octant]);
    stack.push(permuted(load<Ints>(node.links), order), permuted(enter, order), permuted_bits(met, order));
}

template <WideOptions Options>
void push(WideStack &stack, const WideNode &node, unsigned octant, Floats enter, unsigned met) {
    if constexpr (Options.order == WideOptions::Order::octant)
        push_by_octant(stack, node, octant, enter, met);
    else
        push_by_distance(stack, node, enter, met);
}

} // namespace course
