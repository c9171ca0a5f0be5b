// Lesson 15, step 4: eight triangles at once, in float, with bounds: those that the ray may hit are few.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_ray.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace course {

// A leaf's triangles side by side: five cache lines. Lanes beyond the last triangle repeat it.
struct alignas(64) TriangleLeaf {
    float corners[3][3][lanes]; // by corner, axis, triangle
    Id ids[lanes];

    // Room for eight, whatever they are.
    static bool fits(std::span<const Triangle<float>>, std::span<const Id>) { return true; }

    TriangleLeaf(std::span<const Triangle<float>> triangles, std::span<const Id> order, Id first, Id count) {
        for (Id i = 0; i < lanes; ++i) {
            ids[i] = order[first + std::min(i, count - 1)];
            const Triangle<float> &triangle = triangles[ids[i]];
            for (int axis = 0; axis < 3; ++axis) {
                corners[0][axis][i] = triangle.a[axis];
                corners[1][axis][i] = triangle.b[axis];
                corners[2][axis][i] = triangle.c[axis];
            }
        }
    }

    float at(unsigned corner, std::size_t axis, unsigned lane) const { return corners[corner][axis][lane]; }
    Id id(std::span<const Id>, unsigned lane) const { return ids[lane]; }
};
static_assert(sizeof(TriangleLeaf) == 5 * 64);

// Eight corners as the ray sees them.
struct Seen8 {
    Floats x, y, z;
};

[[gnu::always_inline]] inline Seen8 seen(const WideRay &ray, const float (&points)[3][lanes]) {
    const auto from_eye = [&](unsigned i) { return load(points[ray.axes[i]]) - all(ray.origin[i]); };
    const Floats x = from_eye(0), y = from_eye(1), z = from_eye(2);
    return {fused(z, all(ray.per_ahead[0]), x), fused(z, all(ray.per_ahead[1]), y), z};
}

// The first, second and third corners of a leaf's triangles.
[[gnu::always_inline]] inline std::array<Seen8, 3> corners_seen(const WideRay &ray, const TriangleLeaf &leaf) {
    return {seen(ray, leaf.corners[0]), seen(ray, leaf.corners[1]), seen(ray, leaf.corners[2])};
}

inline Floats edge_function(const Seen8 &b, const Seen8 &c) { return fused(c.x, b.y, -(c.y * b.x)); }

// What is known of eight triangles without doubles. A hit's z is depth / area, where depth is right to within slack,
// and area, which is the sum of the edge functions, to within 4 doubt.
struct Candidates {
    unsigned bits;   // on these, chapter 08 may find a hit with 0 < t < t_max; on the others it surely does not
    unsigned inside; // these the ray's line surely goes through
    Floats depth, area, slack, doubt;
    Floats side; // of those inside, at least the longest side of the box around it

    // Between these the hit's z surely is, for those inside. (Last come the roundings of these lines themselves.) to()
    // is good only where from() > 0: there area > 4 doubt, since else depth would be smaller than its slack.
    Floats from() const { return (depth - slack) / (area + 4 * doubt) * (1 - 0x1p-20f); }
    Floats to() const { return (depth + slack) / (area - 4 * doubt) * (1 + 0x1p-20f); }
    // Those inside whose t chapter 08 surely confirms (README.md), if from() > 0.
    template <WideOptions Options> unsigned confirmed() const {
        const Floats least = (depth - slack) * (area - 4 * doubt);
        const Floats most = side * side * (depth + slack + side * (area + 4 * doubt));
        return Options.quick_t ? above(least, fused(all(Options.clear_bound * 0x1p-17f), most, all(0x1p-100f))) : 0;
    }
};

// README.md derives `doubt`, by how much an edge function may be off, and `slack`, the same for the depth. Every
// comparison with NaN says no, so what cannot be told stays a candidate, and is not inside.
template <WideOptions Options, class Leaf>
[[gnu::always_inline]] inline Candidates candidates(const WideRay &ray, const Leaf &leaf, float t_max) {
    const auto [a, b, c] = corners_seen(ray, leaf);
    const Floats u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    const Floats aside = larger_size(larger_size(larger_size(a.x, a.y), larger_size(b.x, b.y)), larger_size(c.x, c.y));
    const Floats far = larger_size(larger_size(a.z, b.z), c.z);
    // In units of epsilon, so that they overflow before what they bound does: then all is in doubt.
    const Floats off = fused(all(13), aside, fused(all(16), far, all(ray.lost)));
    const Floats edge = Options.edge_bound * off * fused(all(0x1p-25f), off, aside);
    const Floats doubt = fused(all(0x1p-24f), edge, all(0x1p-120f));
    const Floats low = smaller(smaller(u, v), w), high = larger(larger(u, v), w);
    const unsigned beside = above(-doubt, low) & above(high, doubt), inside = above(low, doubt) | above(-doubt, high);

    const Floats sum = u + v + w, area = absolute(sum);
    const Floats depth = turned(turned(fused(u, a.z, fused(v, b.z, w * c.z)), sum), all(ray.along));
    const Floats slack = fused(all(Options.depth_bound * 0x1p-24f), fused(area, off, 4 * edge * far), all(0x1p-120f));
    const unsigned behind = above(-slack, depth);
    const unsigned beyond = above(fused(area, all(-t_max), depth), fused(4 * doubt, all(t_max), slack));
    const Floats length = larger(larger(a.z, b.z), c.z) - smaller(smaller(a.z, b.z), c.z);
    return {~(beside | behind | beyond), inside, depth, area, slack, doubt, 4 * aside + length};
}

} // namespace course
