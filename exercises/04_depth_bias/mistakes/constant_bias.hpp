// Mistake: a constant bias: too little for an inclined surface and too much for a level one.
// Caught by: no place of a surface shadows itself
#pragma once
#include "exercises/04_depth_bias/task.hpp"

#include <algorithm>
#include <cmath>

namespace course::exercise {

inline double depth_bias(const MapView &view, const Vec<double> &point, const Vec<double> &normal) {
    (void)view, (void)point, (void)normal;
    return 0.005;
}

inline constexpr Task task{depth_bias};

} // namespace course::exercise
