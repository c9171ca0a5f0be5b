// Mistake: > 0 without a rule for 0, as the notes print it: a ray through a shared edge hits neither neighbour.
// Caught by: through an edge: one of the two neighbours
#pragma once
#include "exercises/08_watertight_edge/task.hpp"

#include <cmath>

namespace course::exercise {

inline bool holds_ray(const Corner &a, const Corner &b, const Corner &c) {
    const double u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

inline constexpr Task task{holds_ray};

} // namespace course::exercise
