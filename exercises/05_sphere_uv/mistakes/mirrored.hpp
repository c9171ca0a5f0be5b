// Mistake: z has the wrong sign, so the map is seen as in a mirror.
// Caught by: the four winds
#pragma once
#include "exercises/05_sphere_uv/task.hpp"

#include <cmath>

namespace course::exercise {

inline MapPlace on_globe(const Vec<double> &direction) {
    const double turn = std::atan2(direction.z, direction.x) / (2 * pi);
    const double u = turn < 0 ? turn + 1 : turn;
    const double from_north = std::atan2(std::hypot(direction.x, direction.z), direction.y);
    return {u < 1 ? u : 0, 1 - from_north / pi};
}

inline constexpr Task task{on_globe};

} // namespace course::exercise
