// Exercise 04: the bias of a shadow map that is just enough. README.md says what is asked.
#pragma once
#include "exercises/04_depth_bias/task.hpp"

#include <algorithm>
#include <cmath>

namespace course::exercise {

inline double depth_bias(const MapView &view, const Vec<double> &point, const Vec<double> &normal) {
    not_done(view, point, normal); // put your own lines in place of this one
}

inline constexpr Task task{depth_bias}; // hands your function to the grader: leave it as it is

} // namespace course::exercise
