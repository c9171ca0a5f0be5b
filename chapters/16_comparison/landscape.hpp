// Lesson 16, step 6: a height field, of as many triangles as wanted.
#pragma once
#include "chapters/16_comparison/patches.hpp"
#include "common/random.hpp"

#include <cmath>
#include <cstdint>

namespace course {

// A random height for each point of the lattice of whole numbers, blended smoothly in between (value noise).
inline double value_noise(double x, double z, std::uint64_t seed) {
    const double x0 = std::floor(x), z0 = std::floor(z);
    const auto height = [&](double i, double j) {
        return Random(seed, static_cast<std::uint64_t>((i + 4096) * 8192 + (j + 4096))).uniform();
    };
    const auto smooth = [](double s) { return s * s * (3 - 2 * s); };
    const double s = smooth(x - x0), t = smooth(z - z0);
    return std::lerp(std::lerp(height(x0, z0), height(x0 + 1, z0), s),
                     std::lerp(height(x0, z0 + 1), height(x0 + 1, z0 + 1), s), t);
}

// Hills on hills on hills: each octave half as wide and half as high.
inline double terrain_height(double x, double z, std::uint64_t seed) {
    double sum = 0;
    for (int octave = 0; octave < 8; ++octave)
        sum +=
            std::ldexp(value_noise(std::ldexp(2 * x, octave), std::ldexp(2 * z, octave), seed + 100 + octave), -octave);
    return 0.35 * sum;
}

// 2 cells² triangles over the square from -1 to 1. The hills are the same however fine they are cut.
inline Triangles terrain(int cells, std::uint64_t seed) {
    Triangles list;
    list.reserve(2 * static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    add_patch(list, cells, cells, [seed](double u, double v) {
        const double x = 2 * u - 1, z = 1 - 2 * v;
        return Vec<double>(x, terrain_height(x, z, seed), z);
    });
    return list;
}

} // namespace course
