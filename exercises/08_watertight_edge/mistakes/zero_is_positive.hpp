// Mistake: 0 counts as positive. But the two neighbours see their edge in opposite directions, and 0 is positive for
// both. Caught by: through an edge: one of the two neighbours
#pragma once
#include "exercises/08_watertight_edge/task.hpp"

#include <cmath>

namespace course::exercise {

inline bool holds_ray(const Corner &a, const Corner &b, const Corner &c) {
    const auto side = [](const Corner &p, const Corner &q) {
        const double edge = q.x * p.y - q.y * p.x;
        return edge != 0 ? edge : 1.0;
    };
    const double u = side(b, c), v = side(c, a), w = side(a, b);
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

inline constexpr Task task{holds_ray};

} // namespace course::exercise
