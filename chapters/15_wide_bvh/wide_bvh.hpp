// Lesson 15, step 6b: the wide BVH.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/15_wide_bvh/leaf_test.hpp"
#include "chapters/15_wide_bvh/walk.hpp"

#include <type_traits>

namespace course {

template <class Shape, WideOptions Options> inline constexpr bool is_packed =
    std::is_same_v<Shape, Triangle<float>> &&Options.leaf != WideOptions::Leaf::one_by_one;

template <Bounded S, WideOptions Options = {}> struct WideBvhBy {
    using Shape = S;
    static constexpr bool packed = is_packed<Shape, Options>;

    WideTree tree;
    std::conditional_t<packed, PackedTriangles<Options>, ShapeList<Shape>> shapes; // in the order of the leaves
    Box<float> box;

    explicit WideBvhBy(std::span<const Shape> given) : tree(tree_of(given)), shapes(shapes_of(given)), box(tree.box) {
        tree.order = {};
    }
    std::size_t node_bytes() const { return tree.nodes.size() * sizeof(WideNode); }

  private:
    static WideTree tree_of(std::span<const Shape> given);
    auto shapes_of(std::span<const Shape> given) {
        if constexpr (packed)
            return PackedTriangles<Options>(given, tree);
        else
            return ShapeList<Shape>(given, tree.order);
    }
};

template <Bounded S, WideOptions Options> WideTree WideBvhBy<S, Options>::tree_of(std::span<const Shape> given) {
    // Two triangles have six corners at most, so they fit into any leaf.
    const BinnedSah rule{Options.leaf == WideOptions::Leaf::compact ? std::size_t{2} : 8, 1.5f};
    const auto boxes = float_boxes(given);
    const auto fits = [&](std::span<const Id> ids) {
        if constexpr (packed)
            return PackedTriangles<Options>::Leaf::fits(given, ids);
        else
            return !ids.empty();
    };
    return Collapser(TreeBuilder(boxes, can_be_hit(boxes), rule).build(), fits, Options.collapse,
                     packed ? WideCosts{1, 0} : WideCosts{0.3f, 0.7f})
        .collapse();
}

template <class Shape> using WideBvh = WideBvhBy<Shape>;

// Any shape: the structure's contract, from which chapter 09 makes all else.
template <class R, class Shape, WideOptions Options, class Test>
void traverse(R &ray, const WideBvhBy<Shape, Options> &bvh, Test &&test) {
    const WideRay wide = wide_ray<Options>(ray, bvh.tree);
    walk<Options>(ray, wide, bvh.tree, [&](WideLink leaf, float &t_max) {
        Id first = leaf.first();
        if constexpr (is_packed<Shape, Options>)
            first = PackedTriangles<Options>::first_slot(leaf);
        for (Id slot = first; slot < first + leaf.count(); ++slot)
            if (test(slot))
                return true;
        t_max = wide.rounded_up(static_cast<double>(ray.t_max));
        return false;
    });
}

// ---- Packed triangles -----------------------------------------------------------------------------------------------

template <class R, WideOptions Options>
    requires is_packed<Triangle<float>, Options> Hit<typename R::Scalar>
    closest_hit(const R &ray, const WideBvhBy<Triangle<float>, Options> &bvh) {
        const WideRay wide = wide_ray<Options>(ray, bvh.tree);
        TriangleSearch<Options, R> search(ray, wide, bvh.shapes);
        walk<Options>(
            ray, wide, bvh.tree, [&](WideLink link, float &t_max) __attribute__((always_inline)) {
                search.look(link, t_max);
                return false;
            });
        return search.closest();
    }

template <class R, WideOptions Options>
    requires is_packed<Triangle<float>, Options>
bool any_hit(const R &ray, const WideBvhBy<Triangle<float>, Options> &bvh) {
    const WideRay wide = wide_ray<Options>(ray, bvh.tree);
    TriangleSearch<Options, R> search(ray, wide, bvh.shapes);
    bool found = false;
    const auto leaf = [&](WideLink link, auto &...) __attribute__((always_inline)) {
        return found = search.hits(link);
    };
    if constexpr (Options.any_hit_loop)
        walk_any<Options>(ray, wide, bvh.tree, leaf);
    else
        walk<Options>(ray, wide, bvh.tree, leaf);
    return found;
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

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template struct WideBvhBy<Triangle<>>;
#endif

} // namespace course
