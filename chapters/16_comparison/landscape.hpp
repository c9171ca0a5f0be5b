// Lesson 16, step 6: a height field, of as many triangles as wanted, and a mountain after Haines's databases (1987).
#pragma once
#include "chapters/08_mesh/ball.hpp"
#include "chapters/16_comparison/patches.hpp"
#include "common/random.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

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

// The middle of an edge of the mountain, raised or lowered by `most` at most. What is drawn depends on the place alone,
// so both triangles at an edge agree.
inline Vec<float> broken_middle(const Vec<float> &a, const Vec<float> &b, double most, std::uint64_t seed) {
    Vec<float> middle = 0.5f * (a + b);
    const std::uint64_t place = std::uint64_t{std::bit_cast<std::uint32_t>(middle.x)} << 32;
    Random random(seed, place | std::bit_cast<std::uint32_t>(middle.z));
    middle.y += static_cast<float>(random.uniform(-most, most));
    return middle;
}

// A pyramid whose triangles are broken into four, `level` times over, each time half as roughly (Fournier, Fussell and
// Carpenter 1982); around it four balls.
inline Triangles mount(int level, int ball_level, std::uint64_t seed) {
    const Vec<float> top(0, 0.9f, 0), a(-1, 0, 1), b(1, 0, 1), c(1, 0, -1), d(-1, 0, -1);
    Triangles list{{a, b, top}, {b, c, top}, {c, d, top}, {d, a, top}};
    for (double most = 0.22; level > 0; --level, most /= 2) {
        Triangles finer;
        finer.reserve(4 * list.size());
        for (const auto &[p, q, r] : list) {
            const Vec<float> pq = broken_middle(p, q, most, seed), qr = broken_middle(q, r, most, seed),
                             rp = broken_middle(r, p, most, seed);
            finer.insert(finer.end(), {{p, pq, rp}, {q, qr, pq}, {r, rp, qr}, {pq, qr, rp}});
        }
        list = std::move(finer);
    }
    for (const Vec<float> &centre : {Vec<float>(-0.7f, 0.75f, 0.5f), Vec<float>(0.7f, 0.75f, 0.5f),
                                     Vec<float>(0.55f, 1.05f, -0.5f), Vec<float>(-0.55f, 1.05f, -0.5f)})
        for (const auto &[p, q, r] : triangles(ball(ball_level)))
            list.push_back({centre + 0.2f * p, centre + 0.2f * q, centre + 0.2f * r});
    return list;
}

} // namespace course
