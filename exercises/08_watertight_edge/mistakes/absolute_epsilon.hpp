// Mistake: what is smaller than an epsilon is called 0. It depends on the scale what is small, and the signs of three
// edges no longer fit together. Caught by: there is no tolerance in it
#pragma once
#include "exercises/08_watertight_edge/task.hpp"

#include <cmath>

namespace course::exercise {

inline bool holds_ray(const Corner &a, const Corner &b, const Corner &c) {
    const auto side = [](const Corner &p, const Corner &q) {
        const double edge = q.x * p.y - q.y * p.x;
        return std::abs(edge) > 1e-9 ? edge : q.y != p.y ? q.y - p.y : p.x - q.x;
    };
    const double u = side(b, c), v = side(c, a), w = side(a, b);
    return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

inline constexpr Task task{holds_ray};

} // namespace course::exercise
