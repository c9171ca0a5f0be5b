// Lesson 15, step 4: eight triangles at once, with the very arithmetic of chapter 08's watertight test.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "chapters/15_wide_bvh/lanes.hpp"
#include "chapters/15_wide_bvh/options.hpp"

#include <algorithm>
#include <span>

namespace course {

// A leaf's triangles side by side: five cache lines. Lanes beyond the last triangle repeat it.
struct alignas(64) TriangleLeaf {
    float corners[3][3][lanes]; // by corner, axis, triangle
    Id ids[lanes];

    TriangleLeaf(std::span<const Triangle<float>> triangles, std::span<const Id> given) {
        for (std::size_t i = 0; i < lanes; ++i) {
            ids[i] = given[std::min(i, given.size() - 1)];
            const Triangle<float> &triangle = triangles[ids[i]];
            for (int axis = 0; axis < 3; ++axis) {
                corners[0][axis][i] = triangle.a[axis];
                corners[1][axis][i] = triangle.b[axis];
                corners[2][axis][i] = triangle.c[axis];
            }
        }
    }

    Triangle<float> operator[](unsigned lane) const {
        const auto corner = [&](int k) -> Vec<float> {
            return {corners[k][0][lane], corners[k][1][lane], corners[k][2][lane]};
        };
        return {corner(0), corner(1), corner(2)};
    }
};
static_assert(sizeof(TriangleLeaf) == 320);

// Eight corners as the ray sees them.
struct Seen8 {
    Doubles x, y, z;
};

[[gnu::always_inline]] inline Seen8 seen(const Shear &shear, const float (&corners)[3][lanes]) {
    const auto along = [&](int axis, double origin) { return widened(load(corners[axis])) - all(origin); };
    const Vec<int> axes = shear.axes();
    const Vec<double> &origin = shear.origin(), &direction = shear.direction();
    const Doubles x = along(axes.x, origin.x), y = along(axes.y, origin.y), z = along(axes.z, origin.z);
    const Doubles dx = all(direction.x), dy = all(direction.y), dz = all(direction.z);
    return {x * dz - dx * z, y * dz - dy * z, z};
}

inline Doubles edge_function(const Seen8 &b, const Seen8 &c) { return c.x * b.y - c.y * b.x; }

// What of a leaf may be hit, a bit for each, with the edge functions and the mean that chapter 08 makes t of.
struct Candidates {
    unsigned bits, in_doubt; // in_doubt: the ray meets the line of an edge, as far as double can tell
    Doubles u, v, w, sum;
};

// The arithmetic is chapter 08's, so where all three edge functions have the same sign, and it is sure, this is the
// decision that the scalar test comes to. What lies behind the origin is left out: there t <= 0.
template <WideOptions Options>
[[gnu::always_inline]] inline Candidates candidates(const Shear &shear, const TriangleLeaf &leaf, Id count) {
    const Seen8 a = seen(shear, leaf.corners[0]), b = seen(shear, leaf.corners[1]), c = seen(shear, leaf.corners[2]);
    const Doubles u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    const Doubles sum = u * a.z + v * b.z + w * c.z;
    const unsigned u_sign = signs(u), sum_sign = signs(sum * all(shear.along()));
    const unsigned out = (u_sign ^ signs(v)) | (u_sign ^ signs(w)) | (u_sign ^ sum_sign);
    const unsigned doubt = Options.edges_in_doubt ? ~above(absolute(u * v * w), Doubles{}) : 0;
    const unsigned there = (1u << count) - 1;
    return {(~out | doubt) & there, doubt, u, v, w, sum};
}

// A triangle whose t is known.
template <class T> struct KnownHit { T t; };
template <class T> std::optional<T> intersect(const Ray<T> &ray, const KnownHit<T> &hit) {
    return in_range(ray, hit.t) ? std::optional<T>(hit.t) : std::nullopt;
}

// Whether chapter 08's confirmed_t() would return t as it is, for a triangle that is seen with twice this area.
// README.md derives the bound.
inline bool is_clear(const TriangleLeaf &leaf, unsigned lane, double area, double t, double along, double bound) {
    float side = 0; // of the triangle's box, the longest
    for (const auto axis : {0, 1, 2}) {
        const float a = leaf.corners[0][axis][lane], b = leaf.corners[1][axis][lane], c = leaf.corners[2][axis][lane];
        side = std::max({side, std::abs(b - a), std::abs(c - a), std::abs(c - b)});
    }
    const double s = static_cast<double>(side), h = std::abs(t * along);
    return std::abs(area) * h >= bound * along * along * s * s * (h + s);
}

// Out of the way of the walk's registers.
template <WideOptions Options, class R> [[gnu::noinline]] void
closest_of_candidates(R &search, const TriangleLeaf &leaf, const Candidates &found, Hit<typename R::Scalar> &best) {
    using T = typename R::Scalar;
    for (unsigned bits = found.bits; bits; bits &= bits - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(bits));
        const double area = found.u[lane] + found.v[lane] + found.w[lane], along = search.shear.along();
        const double t = found.sum[lane] / (area * along);
        const double bound = static_cast<double>(Options.clear_bound) * 0x1p-16;
        if (Options.quick_t && !(found.in_doubt >> lane & 1) && is_clear(leaf, lane, area, t, along, bound))
            closest_of(search, KnownHit<T>{static_cast<T>(t)}, leaf.ids[lane], best);
        else
            closest_of(search, leaf[lane], leaf.ids[lane], best);
    }
}

} // namespace course
