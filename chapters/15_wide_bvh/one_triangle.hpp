// Lesson 15, step 5b: one triangle, exactly: what chapter 08's watertight() sees, its three corners side by side.
#pragma once
#include "chapters/15_wide_bvh/triangle_list.hpp"

#include <algorithm>
#include <cmath>

namespace course {

struct ExactlySeen {
    Triple64 edges; // u, v and w
    double area, depth, along;

    bool surely_inside() const { return std::max(holding(edges > 0), holding(edges < 0)) == 7; }
    // Of one that the ray's line goes through: whether t <= 0, by the signs of what t is made of.
    bool behind() const { return std::signbit(depth) != (std::signbit(area) != std::signbit(along)); }
    double t() const { return depth / (area * along); } // chapter 08's, to the last bit
};

template <class R, class Leaf> [[gnu::always_inline]] inline ExactlySeen exactly_seen(const R &ray, const WideRay &wide,
                                                                                      const Leaf &leaf, unsigned lane) {
    const auto of = [&](const auto &vector, unsigned i) { return static_cast<double>((&vector.x)[wide.axes[i]]); };
    const auto from_eye = [&](unsigned i) {
        const std::size_t axis = wide.axes[i];
        return widened(Triple32{leaf.at(0, axis, lane), leaf.at(1, axis, lane), leaf.at(2, axis, lane), 0}) -
               of(ray.origin, i);
    };
    const double along = of(ray.direction, 2);
    const Triple64 z = from_eye(2), x = from_eye(0) * along - of(ray.direction, 0) * z,
                   y = from_eye(1) * along - of(ray.direction, 1) * z;
    const Triple64 edges = zxy(x) * yzx(y) - zxy(y) * yzx(x), depths = edges * z;
    return {edges, edges[0] + edges[1] + edges[2], depths[0] + depths[1] + depths[2], along};
}

// Whether chapter 08's confirmed_t() surely returns t as it is. README.md derives the bound.
template <WideOptions Options, class Leaf>
bool surely_confirmed(const ExactlySeen &seen, const Leaf &leaf, unsigned lane) {
    Triple32 sides{}; // at least the sides of the box around the first corner and each of the others
    for (const std::size_t axis : {0u, 1u, 2u}) {
        const Triple32 corners{leaf.at(0, axis, lane), leaf.at(1, axis, lane), leaf.at(2, axis, lane), 0};
        sides = larger(sides, absolute(corners - corners[0]));
    }
    const auto side = static_cast<double>(sides[1] + sides[2]);
    const double bound = static_cast<double>(Options.clear_bound) * 0x1p-17 * seen.along * seen.along;
    const double area = std::abs(seen.area), depth = std::abs(seen.depth);
    return Options.quick_t && depth * area >= bound * side * side * (depth + side * area);
}

} // namespace course
