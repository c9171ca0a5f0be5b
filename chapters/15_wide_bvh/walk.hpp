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

// Calls leaf(link, t_max) for every leaf that the ray may hit something in, near ones first; it returns true to end the
// walk. What it finds narrows ray.t_max.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline void walk(const R &ray, const WideRay &wide, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    float t_max = wide.t_max;
    WideStack stack;
    unsigned waiting = 0;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            const float before = t_max;
            if (leaf(at, t_max))
                return;
            if (t_max < before)
                waiting = stack.drop_beyond(waiting, t_max);
        } else {
            ray.counts().node();
            const WideNode &node = tree.nodes[at.first()];
            const auto entries = wide(node, t_max);
            if constexpr (Options.one_hit_path) {
                if (const unsigned met = entries.met(); met != 0 && (met & (met - 1)) == 0) {
                    at = node.links[lowest(met)];
                    continue;
                }
            }
            waiting = push<Options>(stack, waiting, node, wide.octant, entries);
        }
        if (waiting == 0)
            return;
        at = stack[--waiting];
    }
}

// The same for a shadow ray, which neither cares what comes first nor narrows its interval: no order, no distances.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline void walk_any(const R &ray, const WideRay &wide, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    WideLinks stack;
    unsigned waiting = 0;
    float t_max = wide.t_max;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            if (leaf(at, t_max))
                return;
        } else {
            ray.counts().node();
            const WideNode &node = tree.nodes[at.first()];
            waiting = stack.push(waiting, load<Ints>(node.links), wide(node, t_max).met());
        }
        if (waiting == 0)
            return;
        at = stack[--waiting];
    }
}

} // namespace course
