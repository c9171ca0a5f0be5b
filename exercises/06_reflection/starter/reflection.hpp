// Exercise 06: mirrors, and when to stop. README.md says what is asked.
#pragma once
#include "exercises/06_reflection/task.hpp"

#include <cmath>

namespace course::exercise {

inline Vec<double> mirrored(const Vec<double> &direction, const Vec<double> &normal) {
    not_done(direction, normal); // put your own lines in place of this one
}

inline Colour light_along(Ray<double> ray, const Meet &meet, int bounces) {
    not_done(ray, meet, bounces); // put your own lines in place of this one
}

inline constexpr Task task{mirrored, light_along}; // hands your functions to the grader: leave it as it is

} // namespace course::exercise
