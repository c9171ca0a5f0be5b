// Lesson 15, step 4: eight triangles at once, in float, with bounds: those that the ray may hit are few.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_ray.hpp"

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
    Floats x, y, z;
};

[[gnu::always_inline]] inline Seen8 seen(const WideRay &ray, const float (&corners)[3][lanes]) {
    const float *const rows = corners[0];
    const Floats x = load(rows + ray.rows[0]) - all(ray.origin[0]), y = load(rows + ray.rows[1]) - all(ray.origin[1]),
                 z = load(rows + ray.rows[2]) - all(ray.origin[2]);
    return {fused(z, all(ray.x_per_z), x), fused(z, all(ray.y_per_z), y), z};
}

inline Floats edge_function(const Seen8 &b, const Seen8 &c) { return fused(c.x, b.y, -(c.y * b.x)); }

// A bit for each triangle that chapter 08 may find a hit on with 0 < t < t_max; no bit where it surely does not.
// README.md derives `doubt`, by how much an edge function may be off, and `slack`, the same for the depth. Every
// comparison with NaN says no, so what cannot be told stays.
template <WideOptions Options>
[[gnu::always_inline]] inline unsigned candidates(const WideRay &ray, const TriangleLeaf &leaf, float t_max) {
    const Seen8 a = seen(ray, leaf.corners[0]), b = seen(ray, leaf.corners[1]), c = seen(ray, leaf.corners[2]);
    const Floats u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    const Floats aside = larger_size(larger_size(larger_size(a.x, a.y), larger_size(b.x, b.y)), larger_size(c.x, c.y));
    const Floats far = larger_size(larger_size(a.z, b.z), c.z);
    // In units of epsilon, so that they overflow before what they bound does: then all is in doubt.
    const Floats off = fused(all(13), aside, fused(all(16), far, all(ray.lost)));
    const Floats edge = Options.edge_bound * off * fused(all(0x1p-25f), off, aside);
    const Floats doubt = fused(all(0x1p-24f), edge, all(0x1p-120f));
    const Floats low = smaller(smaller(u, v), w), high = larger(larger(u, v), w);
    const unsigned beside = above(-doubt, low) & above(high, doubt);

    const Floats sum = u + v + w, area = absolute(sum); // a hit's z is depth / area
    const Floats depth = turned(all(ray.ahead) * fused(u, a.z, fused(v, b.z, w * c.z)), sum);
    const Floats slack = fused(all(Options.depth_bound * 0x1p-24f), fused(area, off, 4 * edge * far), all(0x1p-120f));
    const unsigned behind = above(-slack, depth);
    const unsigned beyond = above(fused(area, all(-t_max), depth), fused(4 * doubt, all(t_max), slack));
    return ~(beside | behind | beyond);
}

} // namespace course
