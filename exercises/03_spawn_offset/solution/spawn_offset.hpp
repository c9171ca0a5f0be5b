// Exercise 03, solved: a ray that leaves a surface and neither sticks nor leaks.
#pragma once
#include "exercises/03_spawn_offset/task.hpp"

#include <cmath>

namespace course::exercise {

inline Ray<double> leaving(const Vec<double> &point, const Vec<double> &normal, const Vec<double> &direction,
                           const Sphere<float> &sphere) {
    const Vec<double> centre(sphere.centre);
    const auto sum = [](const Vec<double> &v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const double bound = 0x1p-48 * (sum(point) + sum(centre) + static_cast<double>(sphere.radius));
    const double side = dot(direction, normal) < 0 ? -1 : 1;
    return {point + side * bound * normal, direction};
}

inline constexpr Task task{leaving};

} // namespace course::exercise
