// Lesson 15, step 6: the walk of one ray through the tree.
#pragma once
#include "chapters/15_wide_bvh/collapse.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_ray.hpp"
#include "chapters/15_wide_bvh/wide_stack.hpp"

namespace course {

template <class R> Shear shear_of(const R &ray) { return Shear(ray); }
template <class R> const Shear &shear_of(const Sheared<R> &ray) { return ray.shear; }

template <WideOptions Options, class R>
[[gnu::always_inline]] inline WideRay wide_ray(const R &ray, const WideTree &tree) {
    return WideRay(shear_of(ray), ray, tree.reach, Options.slab_pad);
}

// Calls leaf(link, t_max) for every leaf that the ray may hit something in, near ones first; it returns true to end the
// walk. What it finds narrows ray.t_max.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline void walk(R &ray, const WideRay &wide, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    float t_max = wide.t_max;
    WideStack stack;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            if (leaf(at, t_max))
                return;
            t_max = wide.scaled(static_cast<double>(ray.t_max));
        } else {
            ray.counts().node();
            const WideNode &node = tree.nodes[at.first()];
            const auto [enter, met] = wide(node, t_max);
            if (Options.one_hit_path && std::has_single_bit(met)) {
                at = node.links[std::countr_zero(met)];
                continue;
            }
            if (met != 0)
                push<Options>(stack, node, wide.octant, enter, met);
        }
        if (!stack.pop(at, t_max))
            return;
    }
}

// The same for a shadow ray, which neither cares what comes first nor narrows its interval: no order, no distances.
template <WideOptions Options, class R, class Leaf>
[[gnu::always_inline]] inline void walk_any(R &ray, const WideRay &wide, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    WideLinks stack;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            if (leaf(at, wide.t_max))
                return;
        } else {
            ray.counts().node();
            const WideNode &node = tree.nodes[at.first()];
            if (const unsigned met = wide(node, wide.t_max).met; met != 0) {
                at = node.links[std::countr_zero(met)];
                stack.push(load<Ints>(node.links), met & (met - 1));
                continue;
            }
        }
        if (!stack.pop(at))
            return;
    }
}

} // namespace course
