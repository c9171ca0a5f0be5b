// Mistake: the arctangent runs from -pi to pi; half of the globe gets a negative u.
// Caught by: all the way round, u runs from 0 to 1
#pragma once
#include "exercises/05_sphere_uv/task.hpp"

#include <cmath>

namespace course::exercise {

inline MapPlace on_globe(const Vec<double> &direction) {
    const double turn = std::atan2(-direction.z, direction.x) / (2 * pi);
    const double from_north = std::atan2(std::hypot(direction.x, direction.z), direction.y);
    return {turn, 1 - from_north / pi};
}

inline constexpr Task task{on_globe};

} // namespace course::exercise
