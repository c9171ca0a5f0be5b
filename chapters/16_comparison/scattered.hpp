// Lesson 16, step 4: scenes without a surface: a soup, needles, hair.
#pragma once
#include "chapters/16_comparison/patches.hpp"
#include "common/random.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace course {

inline Vec<double> point_in_cube(Random &random, double half = 1) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half), z = random.uniform(-half, half);
    return {x, y, z};
}

// Triangles anywhere, each about as large as the room that it has: nothing to tell one place from another.
inline Triangles triangle_soup(std::size_t count, std::uint64_t seed) {
    const double size = 1.2 / std::cbrt(static_cast<double>(count));
    Triangles list;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, i);
        const Vec<double> a = point_in_cube(random);
        const Vec<double> b = a + point_in_cube(random, size), c = a + point_in_cube(random, size);
        list.push_back({a, b, c});
    }
    return list;
}

// Long and thin, criss-cross: the box of each is nearly empty and overlaps thousands of others.
inline Triangles needles(std::size_t count, std::uint64_t seed) {
    Triangles list;
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, i);
        const Vec<double> a = point_in_cube(random), b = a + point_in_cube(random, 0.6);
        const Vec<double> c = b + point_in_cube(random, 0.002);
        list.push_back({a, b, c});
    }
    return list;
}

// Strands that grow from a ball and bend down, each a ribbon of `pieces` quads, narrower to the tip; under them a head.
inline Triangles hair(std::size_t strands, int pieces, std::uint64_t seed) {
    Triangles list;
    add_sphere(list, 64, 32, {0, 0, 0}, 0.99);
    for (std::size_t i = 0; i < strands; ++i) {
        Random random(seed, i);
        Vec<double> root = point_in_cube(random);
        while (dot(root, root) > 1 || dot(root, root) < 0.01)
            root = point_in_cube(random);
        root = normalize(root);
        const Vec<double> grow = normalize(root + 0.3 * point_in_cube(random));
        const Vec<double> side = 0.004 * AxisFrame(grow)(around_z(random.uniform()));
        const double length = random.uniform(0.5, 0.9), weight = random.uniform(0.5, 0.9);
        add_patch(list, 1, pieces, [&](double u, double v) {
            const Vec<double> at = root + v * length * grow - Vec<double>(0, weight * v * v, 0);
            return at + (u - 0.5) * (1 - 0.8 * v) * side;
        });
    }
    return list;
}

} // namespace course
