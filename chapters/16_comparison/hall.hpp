// Lesson 16, step 7: a colonnaded hall: walls of two triangles beside capitals of thousands.
#pragma once
#include "chapters/16_comparison/patches.hpp"

#include <cmath>

namespace course {

// Twenty shallow grooves run up a column's shaft.
inline void add_column(Triangles &to, int fineness, const Vec<double> &foot, double radius, double height) {
    const int columns = 20 * fineness;
    const Vec<double> up(0, height, 0);
    const auto ring = [&](double u, double y, double r) {
        return foot + Vec<double>(r * std::cos(2 * pi * u), y, -r * std::sin(2 * pi * u));
    };
    add_box(to, foot - Vec<double>(1.5 * radius, 0, 1.5 * radius),
            foot + Vec<double>(1.5 * radius, 0.3 * radius, 1.5 * radius));
    add_patch(to, columns, 2 * fineness, [&](double u, double v) { // the torus of the base
        return ring(u, (0.3 + 0.5 * v) * radius, radius * (1.1 + 0.3 * std::sin(pi * v)));
    });
    add_patch(to, columns, 4 * fineness, [&](double u, double v) { // the shaft, which swells and tapers
        const double groove = 0.05 * std::abs(std::sin(10 * 2 * pi * u));
        return ring(u, 0.8 * radius + v * (height - 2.2 * radius), radius * (1 - groove) * (1 - 0.18 * v * v));
    });
    add_patch(to, columns, 2 * fineness, [&](double u, double v) { // the capital opens like a bowl
        return ring(u, height - 1.4 * radius + 0.9 * v * radius, radius * (0.82 + 0.6 * v * v));
    });
    add_box(to, foot + up - Vec<double>(1.5 * radius, 0.5 * radius, 1.5 * radius),
            foot + up + Vec<double>(1.5 * radius, 0, 1.5 * radius));
}

// The arch from a column to the next one at z + 3, with the wall that rests on it, both 1.2 thick.
inline void add_arch(Triangles &to, int fineness, double x, double y, double z) {
    const auto soffit = [&](double u, double across) {
        return Vec<double>(x + 0.6 * across, y + 1.3 * std::sin(pi * u), z + 1.5 - 1.5 * std::cos(pi * u));
    };
    add_patch(to, 16 * fineness, 1, [&](double u, double v) { return soffit(u, 1 - 2 * v); });
    for (const double side : {-1.0, 1.0})
        add_patch(to, 16 * fineness, 1, [&](double u, double v) {
            const Vec<double> below = soffit(side > 0 ? 1 - u : u, side);
            return Vec<double>(below.x, below.y + v * (y + 1.7 - below.y), below.z);
        });
}

// A nave along z between two rows of columns with arches, under a barrel vault; beyond them low walls and the open air.
// `fineness` sets how finely what is round is cut.
inline Triangles hall(int columns_a_side, int fineness) {
    const double end = 1.5 * columns_a_side, half_width = 3, height = 5;
    Triangles list;
    add_box(list, {-2 * half_width, -0.2, -end - 1}, {2 * half_width, 0, end + 1});
    for (const double side : {-1.0, 1.0}) {
        const double x = side * half_width;
        for (int i = 0; i < columns_a_side; ++i) {
            const double z = -end + 3 * i + 1.5;
            add_column(list, fineness, {x, 0, z}, 0.42, height);
            if (i + 1 < columns_a_side)
                add_arch(list, fineness, x, height, z);
        }
        add_box(list, {x - 0.7, height + 1.7, -end}, {x + 0.7, height + 2, end});
        add_box(list, {2 * x - 0.1, 0, -end - 1}, {2 * x + 0.1, 1.1, end + 1});
    }
    add_patch(list, 24 * fineness, 4 * columns_a_side, [&](double u, double v) { // the vault, seen from inside
        return Vec<double>(half_width * std::cos(pi * u), height + 2 + 0.7 * half_width * std::sin(pi * u),
                           end * (1 - 2 * v));
    });
    return list;
}

} // namespace course
