// Lesson 15, step 4b: a leaf in two cache lines. Triangles of a mesh share their corners, so keep each corner once.
#pragma once
#include "chapters/15_wide_bvh/triangle_leaf.hpp"

#include <bit>

namespace course {

// At most eight different corners, and for each triangle which three of them are its own.
struct alignas(64) CompactLeaf {
    float points[3][lanes];    // by axis, point
    std::uint32_t of_lanes[3]; // by corner: three bits for each triangle, the number of its point
    Id first;                  // where the triangles' ids begin among those of all leaves

    static bool fits(std::span<const Triangle<float>> triangles, std::span<const Id> ids) {
        Vec<float> found[lanes];
        unsigned count = 0;
        for (const Id id : ids)
            for (const Vec<float> &corner : {triangles[id].a, triangles[id].b, triangles[id].c})
                if (place_of(corner, found, count) == count) {
                    if (count == lanes)
                        return false;
                    found[count++] = corner;
                }
        return true;
    }

    CompactLeaf(std::span<const Triangle<float>> triangles, std::span<const Id> order, Id from, Id size)
        : points{}, of_lanes{}, first(from) {
        Vec<float> found[lanes];
        unsigned count = 0;
        for (Id lane = 0; lane < lanes; ++lane) {
            const Triangle<float> &triangle = triangles[order[from + std::min(lane, size - 1)]];
            for (const auto &[corner, k] : {std::pair{triangle.a, 0}, {triangle.b, 1}, {triangle.c, 2}}) {
                const unsigned place = place_of(corner, found, count);
                if (place == count)
                    found[count++] = corner;
                of_lanes[k] |= place << 3 * lane;
            }
        }
        for (unsigned i = 0; i < lanes; ++i)
            for (int axis = 0; axis < 3; ++axis)
                points[axis][i] = found[std::min(i, count - 1)][axis];
    }

    float at(unsigned corner, std::size_t axis, unsigned lane) const {
        return points[axis][of_lanes[corner] >> 3 * lane & 7];
    }
    Id id(std::span<const Id> order, unsigned lane) const { return order[first + lane]; }

  private:
    // Where the point is among those found; `count` if it is not. By its bits: 0 and -0 are two points.
    static unsigned place_of(const Vec<float> &point, const Vec<float> *found, unsigned count) {
        unsigned place = 0;
        while (place < count && std::memcmp(&found[place], &point, sizeof point) != 0)
            ++place;
        return place;
    }
};
static_assert(sizeof(CompactLeaf) == 2 * 64);

// Each point is seen once and handed to the triangles that it belongs to.
[[gnu::always_inline]] inline std::array<Seen8, 3> corners_seen(const WideRay &ray, const CompactLeaf &leaf) {
    const Seen8 all_points = seen(ray, leaf.points);
    const auto corners = [&](unsigned k) {
        const Ints of_lanes = unpacked(leaf.of_lanes[k]);
        return Seen8{permuted(all_points.x, of_lanes), permuted(all_points.y, of_lanes),
                     permuted(all_points.z, of_lanes)};
    };
    return {corners(0), corners(1), corners(2)};
}

} // namespace course
