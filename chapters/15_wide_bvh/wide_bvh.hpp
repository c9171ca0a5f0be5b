// Lesson 15, step 6: the wide BVH, and the walk of one ray through it.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/15_wide_bvh/triangle_list.hpp"
#include "chapters/15_wide_bvh/wide_stack.hpp"

#include <type_traits>

namespace course {

template <class Shape, WideOptions Options> inline constexpr bool is_packed =
    std::is_same_v<Shape, Triangle<float>> &&Options.leaf == WideOptions::Leaf::eight;

template <Bounded S, WideOptions Options = {}> struct WideBvhBy {
    using Shape = S;
    static constexpr bool packed = is_packed<Shape, Options>;

    WideTree tree;
    std::conditional_t<packed, TriangleList, ShapeList<Shape>> shapes; // in the order of the leaves
    Box<float> box;

    explicit WideBvhBy(std::span<const Shape> given) : tree(tree_of(given)), shapes(shapes_of(given)), box(tree.box) {
        tree.order = {};
    }
    std::size_t node_bytes() const { return tree.nodes.size() * sizeof(WideNode); }

  private:
    static WideTree tree_of(std::span<const Shape> given) {
        const auto boxes = float_boxes(given);
        const BinnedSah rule = packed ? BinnedSah{8, 1.5f} : BinnedSah{8, 1.5f};
        return Collapser(TreeBuilder(boxes, can_be_hit(boxes), rule).build(), Options.collapse,
                         packed ? WideCosts{1, 0} : WideCosts{0.3f, 0.7f})
            .collapse();
    }
    auto shapes_of(std::span<const Shape> given) {
        if constexpr (packed)
            return TriangleList(given, tree);
        else
            return ShapeList<Shape>(given, tree.order);
    }
};

template <class Shape> using WideBvh = WideBvhBy<Shape>;

// Calls leaf(link) for every leaf that the ray may hit something in, near ones first; it returns true to end the walk.
template <WideOptions Options, class R, class Leaf> void walk(R &ray, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    const WideRay wide(ray, tree.box, Options.slab_pad);
    float t_max = wide.scaled(static_cast<double>(ray.t_max));
    WideStack stack;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            if (leaf(at))
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
                push<Options>(stack, node, wide.octant(), enter, met);
        }
        if (!stack.pop(at, t_max))
            return;
    }
}

// The same for a shadow ray, which neither cares what comes first nor narrows its interval: no order, no distances.
template <WideOptions Options, class R, class Leaf> void walk_any(R &ray, const WideTree &tree, Leaf &&leaf) {
    if (tree.nodes.empty())
        return;
    const WideRay wide(ray, tree.box, Options.slab_pad);
    const float t_max = wide.scaled(static_cast<double>(ray.t_max));
    WideLinks stack;
    WideLink at = WideLink::node(0);
    while (true) {
        if (at.is_leaf()) {
            if (leaf(at))
                return;
        } else {
            ray.counts().node();
            const WideNode &node = tree.nodes[at.first()];
            if (const unsigned met = wide(node, t_max).met; met != 0) {
                at = node.links[std::countr_zero(met)];
                stack.push(load<Ints>(node.links), met & (met - 1));
                continue;
            }
        }
        if (!stack.pop(at))
            return;
    }
}

// Any shape: the structure's contract, from which chapter 09 makes all else.
template <class R, class Shape, WideOptions Options, class Test>
void traverse(R &ray, const WideBvhBy<Shape, Options> &bvh, Test &&test) {
    walk<Options>(ray, bvh.tree, [&](WideLink leaf) {
        Id first = leaf.first();
        if constexpr (is_packed<Shape, Options>)
            first = TriangleList::first_slot(leaf);
        for (Id slot = first; slot < first + leaf.count(); ++slot)
            if (test(slot))
                return true;
        return false;
    });
}

// ---- Packed triangles -----------------------------------------------------------------------------------------------

// Tests the leaf's triangles; true if one of them is a hit that is better than the best so far.
template <WideOptions Options, class R>
void closest_of_leaf(R &search, const TriangleList &shapes, WideLink link, Hit<typename R::Scalar> &best) {
    const TriangleLeaf &leaf = shapes.leaf(link);
    const Candidates found = candidates<Options>(search.shear, leaf, link.count());
    for (auto tested = static_cast<Id>(std::popcount(found.bits)); tested < link.count(); ++tested)
        search.counts().test(); // the misses; the candidates are counted when they are looked at
    if (found.bits != 0)
        closest_of_candidates<Options>(search, leaf, found, best);
}

template <class R, WideOptions Options>
    requires is_packed<Triangle<float>, Options> Hit<typename R::Scalar>
    closest_hit(const R &ray, const WideBvhBy<Triangle<float>, Options> &bvh) {
        Hit<typename R::Scalar> best;
        auto search = prepared<Triangle<float>>(ray);
        walk<Options>(search, bvh.tree, [&](WideLink link) {
            closest_of_leaf<Options>(search, bvh.shapes, link, best);
            return false;
        });
        return best;
    }

template <class R, WideOptions Options>
    requires is_packed<Triangle<float>, Options>
bool any_hit(const R &ray, const WideBvhBy<Triangle<float>, Options> &bvh) {
    Hit<typename R::Scalar> any;
    auto search = prepared<Triangle<float>>(ray);
    const auto leaf = [&](WideLink link) {
        closest_of_leaf<Options>(search, bvh.shapes, link, any);
        return bool(any);
    };
    if constexpr (Options.any_hit_loop)
        walk_any<Options>(search, bvh.tree, leaf);
    else
        walk<Options>(search, bvh.tree, leaf);
    return bool(any);
}

template <class R, WideOptions Options, class F, class... Context>
    requires is_packed<Triangle<float>, Options>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const WideBvhBy<Triangle<float>, Options> &bvh, F &&f,
              const Context &...context) {
    return with_hit(ray, Hit<typename R::Scalar>{hit.t, 0}, bvh.shapes[bvh.shapes.slot_of(hit.id)], f, context...);
}

template <WideOptions Options>
    requires is_packed<Triangle<float>, Options> Id size(const WideBvhBy<Triangle<float>, Options> &bvh) {
        return bvh.shapes.primitives();
    }

template <WideOptions Options>
    requires is_packed<Triangle<float>, Options> Box<float> bounds(const WideBvhBy<Triangle<float>, Options> &bvh) {
        return bvh.box;
    }

template <WideOptions Options>
    requires is_packed<Triangle<float>, Options> std::size_t bytes(const WideBvhBy<Triangle<float>, Options> &bvh) {
        return bvh.shapes.bytes() + bvh.node_bytes();
    }

} // namespace course
