// Lesson 10, step 6: scenes that are even, uneven and neither, to see what a structure makes of them.
#pragma once
#include "chapters/08_mesh/load.hpp"
#include "chapters/09_aabb/bounds.hpp"
#include "common/random.hpp"
#include "common/viewpoint.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace course {

// The triangles of the file, or of the bunny where no file is named.
inline std::vector<Triangle<>> model(const std::string &file) {
    return triangles(load_mesh(file.empty() ? find_bunny() : std::filesystem::path(file)));
}

inline Box<float> box_around(const std::vector<Triangle<>> &list) { return bounds(std::span<const Triangle<>>(list)); }

// From where a box is seen as a whole, a little from above.
inline Viewpoint seen_whole(const Box<float> &box) {
    const double size = std::max(0.5 * length(extent(box)), 1e-30);
    return {.eye = centre(box) + size * Vec<double>(0.35, 0.75, 3.1), .target = centre(box), .field_of_view = 34};
}

// Even: triangles of one size, anywhere in a cube of edge 2. Their number times their area stays the same, so that a
// soup of many is as thick as one of few.
inline std::vector<Triangle<>> soup(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const auto point = [&](double size) {
        return Vec<float>(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    const double size = 2 / std::sqrt(static_cast<double>(count));
    std::vector<Triangle<>> list;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<float> a = point(1);
        list.push_back({a, a + point(size), a + point(size)});
    }
    return list;
}

// Uneven: what is given, in the middle of a stadium some five hundred times as wide.
inline std::vector<Triangle<>> in_stadium(std::vector<Triangle<>> list) {
    const Box<float> box = box_around(list);
    const Vec<double> middle = centre(box);
    const double size = std::max(0.5 * length(extent(box)), 1e-30), ground = static_cast<double>(box.lo.y);
    constexpr int rows = 48, seats = 96;
    // The rim of row i, an oval: row 0 is the lawn's edge, and each next row is farther and higher.
    const auto rim = [&](int i, int j) -> Vec<float> {
        const double angle = 2 * pi * (j % seats) / seats, out = size * (180 + 3.2 * i);
        return {middle.x + 1.4 * out * std::cos(angle), ground + 1.2 * size * i, middle.z + out * std::sin(angle)};
    };
    for (int j = 0; j < seats / 2; ++j) { // the lawn, in strips across
        const int k = seats - 1 - j;
        if (j + 1 < k)
            list.push_back({rim(0, j), rim(0, k), rim(0, j + 1)});
        if (j > 0)
            list.push_back({rim(0, k + 1), rim(0, k), rim(0, j)});
    }
    for (int j = 0; j < seats; ++j)
        for (int i = 0; i < rows; ++i) {
            list.push_back({rim(i, j), rim(i, j + 1), rim(i + 1, j + 1)});
            list.push_back({rim(i, j), rim(i + 1, j + 1), rim(i + 1, j)});
        }
    return list;
}

} // namespace course
