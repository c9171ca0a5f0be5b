// Mistake: the offset always goes outwards. A ray that goes in meets the surface at once.
// Caught by: a ray that goes in meets the far side
#pragma once
#include "exercises/03_spawn_offset/task.hpp"

#include <cmath>

namespace course::exercise {

inline Ray<double> leaving(const Vec<double> &point, const Vec<double> &normal, const Vec<double> &direction,
                           const Sphere<float> &sphere) {
    const Vec<double> centre(sphere.centre);
    const auto sum = [](const Vec<double> &v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const double bound = 0x1p-48 * (sum(point) + sum(centre) + static_cast<double>(sphere.radius));
    return {point + bound * normal, direction};
}

inline constexpr Task task{leaving};

} // namespace course::exercise
