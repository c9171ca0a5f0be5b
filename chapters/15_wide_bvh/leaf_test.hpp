// Lesson 15, step 5b: the few triangles that the ray may hit, decided as chapter 08 decides.
#pragma once
#include "chapters/15_wide_bvh/triangle_list.hpp"

namespace course {

// A triangle whose t is known.
template <class T> struct KnownHit { T t; };
template <class T> std::optional<T> intersect(const Ray<T> &ray, const KnownHit<T> &hit) {
    return in_range(ray, hit.t) ? std::optional<T>(hit.t) : std::nullopt;
}

// One corner of a triangle as chapter 08 sees it.
inline Seen seen(const Shear &shear, const WideRay &ray, const float (&corners)[3][lanes], unsigned lane) {
    const float *const rows = corners[0] + lane;
    return shear.in_order(static_cast<double>(rows[ray.rows[0]]), static_cast<double>(rows[ray.rows[1]]),
                          static_cast<double>(rows[ray.rows[2]]));
}

// At least the longest side of the box around the triangle.
inline double side_of(const TriangleLeaf &leaf, unsigned lane) {
    float sum = 0;
    for (const auto axis : {0, 1, 2}) {
        const float a = leaf.corners[0][axis][lane];
        sum += std::abs(leaf.corners[1][axis][lane] - a) + std::abs(leaf.corners[2][axis][lane] - a);
    }
    return static_cast<double>(sum);
}

// Out of the way of the walk's registers. The arithmetic is that of chapter 08's watertight(), so t is the same to the
// last bit where its confirmed_t() surely returns t as it is: README.md derives the bound.
template <WideOptions Options, class R>
[[gnu::noinline]] void closest_of_candidates(R &search, const WideRay &wide, const TriangleLeaf &leaf, unsigned bits,
                                             Hit<typename R::Scalar> &best) {
    using T = typename R::Scalar;
    const Shear &shear = search.shear;
    const double along = shear.along(), bound = static_cast<double>(Options.clear_bound) * 0x1p-15 * along * along;
    for (; bits; bits &= bits - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(bits));
        const Seen a = seen(shear, wide, leaf.corners[0], lane), b = seen(shear, wide, leaf.corners[1], lane),
                   c = seen(shear, wide, leaf.corners[2], lane);
        const double u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
        const double area = u + v + w, sum = u * a.z + v * b.z + w * c.z, side = side_of(leaf, lane);
        const bool all_above = std::min({u, v, w}) > 0, all_below = std::max({u, v, w}) < 0;
        const bool same_sign = all_above | all_below;
        const bool behind = std::signbit(sum) != (std::signbit(area) != std::signbit(along));
        if (same_sign & behind) { // t <= 0: where the ray starts, most often
            search.counts().test();
            continue;
        }
        const bool clear = std::abs(sum * area) >= bound * side * side * (std::abs(sum) + side * std::abs(area));
        if (Options.quick_t && same_sign & clear)
            closest_of(search, KnownHit<T>{static_cast<T>(sum / (area * along))}, leaf.ids[lane], best);
        else
            closest_of(search, leaf[lane], leaf.ids[lane], best);
    }
}

// Tests the leaf's triangles; a better hit becomes the best.
template <WideOptions Options, class R>
[[gnu::always_inline]] inline void closest_of_leaf(R &search, const WideRay &wide, const TriangleList &shapes,
                                                   WideLink link, float t_max, Hit<typename R::Scalar> &best) {
    const TriangleLeaf &leaf = shapes.leaf(link);
    const unsigned found = candidates<Options>(wide, leaf, t_max) & ((1u << link.count()) - 1);
    for (auto tested = static_cast<Id>(std::popcount(found)); tested < link.count(); ++tested)
        search.counts().test(); // the misses; the candidates are counted when they are looked at
    if (found != 0)
        closest_of_candidates<Options>(search, wide, leaf, found, best);
}

} // namespace course
