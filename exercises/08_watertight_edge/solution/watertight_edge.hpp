// Exercise 08, solved: a triangle that shares its edges fairly.
#pragma once
#include "exercises/08_watertight_edge/task.hpp"

#include <cmath>

namespace course::exercise {

inline bool holds_ray(const Corner &a, const Corner &b, const Corner &c) {
    // Which side of the edge from p to q the origin is on. Exactly on it, as if the ray passed a hair to the right of
    // where it does, and a hair of that hair above.
    const auto side = [](const Corner &p, const Corner &q) {
        const double edge = q.x * p.y - q.y * p.x;
        return edge != 0 ? edge : q.y != p.y ? q.y - p.y : p.x - q.x;
    };
    const double u = side(b, c), v = side(c, a), w = side(a, b);
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

inline constexpr Task task{holds_ray};

} // namespace course::exercise
