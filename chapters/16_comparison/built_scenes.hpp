// Lesson 16, step 5: scenes with surfaces. The sphereflake, the tetrahedra, the rings, the gears and the tree follow
// the ideas of Haines's Standard Procedural Databases (1987).
#pragma once
#include "chapters/08_mesh/ball.hpp"
#include "chapters/16_comparison/patches.hpp"
#include "common/random.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace course {

// A sphere that bears nine smaller ones, each of which bears nine ... Spheres are balls of chapter 08.
inline void add_flake(Triangles &to, const Triangles &ball, int depth, const Vec<double> &centre, double radius,
                      const Vec<double> &up) {
    for (const auto &[a, b, c] : ball) {
        const auto at = [&](const Vec<float> &p) { return Vec<float>(centre + radius * Vec<double>(p)); };
        to.push_back({at(a), at(b), at(c)});
    }
    if (depth == 0)
        return;
    const AxisFrame frame(up);
    for (int i = 0; i < 9; ++i) { // six around the equator, three above
        const double height = i < 6 ? 0 : std::sqrt(3.0) / 2;
        const double turn = i < 6 ? i / 6.0 : (i - 6) / 3.0 + 1 / 12.0;
        const Vec<double> out = frame(std::sqrt(1 - height * height) * around_z(turn) + Vec<double>(0, 0, height));
        add_flake(to, ball, depth - 1, centre + 4 / 3.0 * radius * out, radius / 3, out);
    }
}
inline Triangles sphereflake(int depth, int ball_level) {
    Triangles list;
    add_flake(list, triangles(ball(ball_level)), depth, {0, 0, 0}, 1, {0, 1, 0});
    return list;
}

// A tetrahedron made of four of half its size, level by level.
inline void add_tetra(Triangles &to, int level, const std::array<Vec<double>, 4> &corners) {
    const auto &[a, b, c, d] = corners;
    if (level == 0) {
        to.insert(to.end(), {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}});
        return;
    }
    for (const Vec<double> &fixed : corners)
        add_tetra(to, level - 1, {0.5 * (fixed + a), 0.5 * (fixed + b), 0.5 * (fixed + c), 0.5 * (fixed + d)});
}
inline Triangles tetra(int level) {
    Triangles list;
    add_tetra(list, level, {{{-1, -0.7, 0.8}, {1, -0.7, 0.8}, {0, -0.7, -0.9}, {0, 0.9, 0}}});
    return list;
}

// Tori, each around a random axis, in a cube of `side`³ places.
inline Triangles rings(int side, int around, int across, std::uint64_t seed) {
    Triangles list;
    for (int i = 0; i < side * side * side; ++i) {
        Random random(seed, static_cast<std::uint64_t>(i));
        const double z = random.uniform(-1, 1);
        const AxisFrame frame(std::sqrt(1 - z * z) * around_z(random.uniform()) + Vec<double>(0, 0, z));
        const Vec<double> centre(i % side, i / side % side, i / side / side);
        add_patch(list, around, across, [&](double u, double v) {
            return centre + frame((0.5 + 0.1 * std::cos(2 * pi * v)) * around_z(u) +
                                  Vec<double>(0, 0, 0.1 * std::sin(2 * pi * v)));
        });
    }
    return list;
}

// A spur gear around z with its middle at `centre`: the hole, two faces, and teeth whose tips reach out to 1.08. At
// longitude 0 there is a tooth, or with `between` a gap. The faces are long triangles from the hole to the rim.
inline void add_gear(Triangles &to, int teeth, const Vec<double> &centre, bool between) {
    const auto rim = [&](double u) { // four corners a tooth: two at the tip, two at the root
        constexpr std::array<double, 4> places{-0.15, 0.15, 0.32, 0.68};
        const int corner = static_cast<int>(std::lround(4 * teeth * u)) % (4 * teeth), of_tooth = corner % 4;
        const double tooth = corner / 4 + places[static_cast<std::size_t>(of_tooth)] + (between ? 0.5 : 0);
        return (of_tooth < 2 ? 1.08 : 0.9) * around_z(tooth / teeth);
    };
    const auto hole = [&](double u) { return 0.3 / length(rim(u)) * rim(u); };
    const Vec<double> up = centre + Vec<double>(0, 0, 0.3), down = centre - Vec<double>(0, 0, 0.3);
    add_patch(to, 4 * teeth, 1, [&](double u, double v) { return up + mix(rim(u), hole(u), v); });
    add_patch(to, 4 * teeth, 1, [&](double u, double v) { return mix(up, down, v) + hole(u); });
    add_patch(to, 4 * teeth, 1, [&](double u, double v) { return down + mix(hole(u), rim(u), v); });
    add_patch(to, 4 * teeth, 1, [&](double u, double v) { return mix(down, up, v) + rim(u); });
}

// Gears in `side` layers of side² that mesh with their neighbours; 4 must divide the number of teeth.
inline Triangles gears(int side, int teeth) {
    Triangles list;
    for (int i = 0; i < side * side * side; ++i) {
        const int x = i % side, y = i / side % side, z = i / side / side;
        add_gear(list, teeth, Vec<double>(2 * x, 2 * y, z), (x + y) % 2 == 1);
    }
    return list;
}

// A trunk that forks into three, and so on; leaves, one triangle each, at the ends.
inline void add_branch(Triangles &to, int level, int columns, const Vec<double> &from, const Vec<double> &way,
                       Random &random) {
    const Vec<double> end = from + way;
    const double thick = 0.07 * length(way);
    add_cone(to, columns, 2, from, thick, end, 0.6 * thick);
    const AxisFrame frame(normalize(way));
    for (int i = 0; i < (level == 0 ? 12 : 3); ++i) {
        const double turn = i / (level == 0 ? 12.0 : 3.0) + random.uniform(-0.1, 0.1);
        const Vec<double> out = 0.6 * frame(around_z(turn)) + random.uniform(0.5, 0.9) * frame.w;
        if (level > 0) {
            add_branch(to, level - 1, columns, end, random.uniform(0.6, 0.8) * length(way) * normalize(out), random);
            continue;
        }
        const Vec<double> leaf = from + random.uniform(0.2, 1.0) * way, tip = leaf + 0.5 * length(way) * out;
        to.push_back({leaf, tip + 0.1 * length(way) * frame.u, tip - 0.1 * length(way) * frame.v});
    }
}
inline Triangles tree(int level, int columns, std::uint64_t seed) {
    Triangles list;
    Random random(seed);
    add_patch(list, 1, 1, [](double u, double v) { return Vec<double>(8 * u - 4, 0, 4 - 8 * v); });
    add_branch(list, level, columns, {0, 0, 0}, {0, 1, 0}, random);
    return list;
}

} // namespace course
