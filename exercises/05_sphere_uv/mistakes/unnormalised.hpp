// Mistake: the arc cosine of y, as if the direction had length one. Beyond 1 it is NaN.
// Caught by: the direction may have any length
#pragma once
#include "exercises/05_sphere_uv/task.hpp"

#include <cmath>

namespace course::exercise {

inline MapPlace on_globe(const Vec<double> &direction) {
    const double turn = std::atan2(-direction.z, direction.x) / (2 * pi);
    const double u = turn < 0 ? turn + 1 : turn;
    const double from_north = std::acos(direction.y);
    return {u < 1 ? u : 0, 1 - from_north / pi};
}

inline constexpr Task task{on_globe};

} // namespace course::exercise
