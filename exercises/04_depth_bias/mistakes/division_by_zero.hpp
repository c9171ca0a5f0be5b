// Mistake: a surface seen edge-on has n · d = 0, and its bias is infinite or NaN.
// Caught by: a surface seen edge-on has a finite bias
#pragma once
#include "exercises/04_depth_bias/task.hpp"

#include <algorithm>
#include <cmath>

namespace course::exercise {

inline double depth_bias(const MapView &view, const Vec<double> &point, const Vec<double> &normal) {
    const Vec<double> to_point = point - view.eye;
    const double depth = dot(to_point, view.forward), texel = 2 * view.half_width / view.texels;
    const double facing = std::abs(dot(normal, to_point)) / depth;
    const double slopes = std::abs(dot(normal, view.right)) + std::abs(dot(normal, view.up));
    return 0.5 * texel * depth * slopes / facing + 0x1p-23 * depth;
}

inline constexpr Task task{depth_bias};

} // namespace course::exercise
