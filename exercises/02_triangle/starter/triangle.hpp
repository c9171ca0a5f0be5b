// Exercise 02: a triangle with its division done in advance. README.md says what is asked.
#pragma once
#include "exercises/02_triangle/task.hpp"

#include <cmath>

namespace course::exercise {

inline ReadyTriangle make_ready(const Vec<float> &a, const Vec<float> &b, const Vec<float> &c) {
    not_done(a, b, c); // put your own lines in place of this one
}

inline std::optional<double> triangle_hit(const Ray<double> &ray, const ReadyTriangle &triangle) {
    not_done(ray, triangle);
}

inline constexpr Task task{make_ready, triangle_hit}; // hands your functions to the grader: leave it as it is

} // namespace course::exercise
