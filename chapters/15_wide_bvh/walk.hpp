// Lesson 15, step 6: the walk of one ray through the tree.
#pragma once
#include "chapters/15_wide_bvh/collapse.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_ray.hpp"
#include "chapters/15_wide_bvh/wide_stack.hpp"

namespace course {

template <WideOptions Options, class R>
[[gnu::always_inline]] inline WideRay wide_ray(const R &ray, const WideTree &tree) {
    return WideRay(ray, tree.reach, Options.slab_pad);
}

// Opens a node, and what waits next together with it, if that is a node as well. Without a branch: a leaf, or the end,
// stays where it is, and none of the root's children are taken. opened(waiting, number, of) lets those of a node's
// children wait whose bits are set in `of`. Returns how many wait then.
template <WideOptions Options, class R, class Opened> [[gnu::always_inline]] inline unsigned
open_nodes(const R &ray, WideLink node, WideLink next, unsigned waiting, const Opened &opened) {
    if constexpr (Options.two_nodes) {
        const bool two = !next.is_leaf();
        if (two)
            ray.counts().node();
        waiting = opened(waiting - two, two ? next.first() : 0, two ? all_children : 0);
    }
    ray.counts().node();
    return opened(waiting, node.first(), all_children);
}

// Opens a node and, as long as one child alone is hit, that child, without the stack. Returns the leaf to which this
// leads; the end if several children, or none, were left to wait.
template <WideOptions Options, class R>
[[gnu::always_inline]] inline WideLink past_single_children(const R &ray, const Slabs<Floats> &boxes,
                                                            const WideTree &tree, float t_max, WideLink at,
                                                            WideStack &stack, unsigned &waiting) {
    while (!at.is_leaf()) {
        ray.counts().node();
        const WideNode &node = tree.nodes[at.first()];
        const auto entries = boxes(node, t_max);
        const unsigned met = entries.met();
        if (!std::has_single_bit(met)) {
            waiting = push<Options>(stack, waiting, node, boxes.octant, entries);
            return WideLink::end();
        }
        at = node.links[lowest(met)];
    }
    return at;
}

// Calls leaf(link, t_max) for every leaf that the ray may hit something in, near ones first; it returns true to end the
// walk. What it finds narrows ray.t_max. Two nodes are opened at a time: the second perhaps for nothing, if the first
// holds a hit before it, but that costs less than to wait for one after the other.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline void walk(const R &ray, const WideRay &wide, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    const Slabs<Floats> boxes(wide.boxes);
    float t_max = wide.t_max;
    WideStack stack;
    const auto opened = [&](unsigned waiting, Id number, unsigned of) __attribute__((always_inline)) {
        const WideNode &node = tree.nodes[number];
        return push<Options>(stack, waiting, node, boxes.octant, boxes(node, t_max), of);
    };
    ray.counts().node();
    unsigned waiting = opened(stack.push(0, WideLink::end(), -infinity<float>), 0, all_children);
    while (waiting > 1) {
        WideLink at = stack[--waiting];
        if constexpr (Options.one_hit_path)
            if (at = past_single_children<Options>(ray, boxes, tree, t_max, at, stack, waiting); at.is_end())
                continue;
        if (at.is_leaf()) {
            const float before = t_max;
            if (leaf(at, t_max))
                return;
            if (t_max < before)
                waiting = stack.drop_beyond(waiting, t_max);
            continue;
        }
        waiting = open_nodes<Options>(ray, at, stack[waiting - 1], waiting, opened);
    }
}

// The same for a shadow ray, which neither cares what comes first nor narrows its interval: no order, no distances.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline void walk_any(const R &ray, const WideRay &wide, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    const Slabs<Floats> boxes(wide.boxes);
    WideLinks stack;
    const auto opened = [&](unsigned waiting, Id number, unsigned of) __attribute__((always_inline)) {
        const WideNode &node = tree.nodes[number];
        return stack.push(waiting, load<Ints>(node.links), boxes(node, wide.t_max).met() & of);
    };
    ray.counts().node();
    unsigned waiting = opened(stack.push(0, WideLink::end()), 0, all_children);
    while (waiting > 1) {
        const WideLink at = stack[--waiting];
        if (at.is_leaf()) {
            if (leaf(at))
                return;
            continue;
        }
        waiting = open_nodes<Options>(ray, at, stack[waiting - 1], waiting, opened);
    }
}

} // namespace course
