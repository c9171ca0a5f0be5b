// Exercise 13: on which sides of a plane is a ray, in what order. README.md says what is asked.
#pragma once
#include "exercises/13_bsp_sides/task.hpp"

namespace course::exercise {

inline Sides sides_met(const Ray<double> &ray, const CutPlane &plane) {
    not_done(ray, plane); // put your own lines in place of this one
}

inline constexpr Task task{sides_met}; // hands your function to the grader: leave it as it is

} // namespace course::exercise
