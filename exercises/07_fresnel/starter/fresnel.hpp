// Exercise 07: where light goes at glass, and how it divides. README.md says what is asked.
#pragma once
#include "exercises/07_fresnel/task.hpp"

#include <cmath>

namespace course::exercise {

inline std::optional<Vec<double>> bent(const Vec<double> &direction, const Vec<double> &normal, double n_from,
                                       double n_to) {
    not_done(direction, normal, n_from, n_to); // put your own lines in place of this one
}

inline Shares divided(double cos_i, double n_from, double n_to) {
    not_done(cos_i, n_from, n_to); // put your own lines in place of this one
}

inline constexpr Task task{bent, divided}; // hands your functions to the grader: leave it as it is

} // namespace course::exercise
