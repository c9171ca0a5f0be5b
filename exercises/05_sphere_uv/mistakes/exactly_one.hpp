// Mistake: a very small negative turn plus 1 is exactly 1 after rounding, and a picture has no column there.
// Caught by: u is never 1
#pragma once
#include "exercises/05_sphere_uv/task.hpp"

#include <cmath>

namespace course::exercise {

inline MapPlace on_globe(const Vec<double> &direction) {
    const double turn = std::atan2(-direction.z, direction.x) / (2 * pi);
    const double u = turn < 0 ? turn + 1 : turn;
    const double from_north = std::atan2(std::hypot(direction.x, direction.z), direction.y);
    return {u, 1 - from_north / pi};
}

inline constexpr Task task{on_globe};

} // namespace course::exercise
