// Exercise 07: what an answer hands over.
#pragma once
#include "common/vectors.hpp"
#include "exercises/grading/not_done.hpp"

#include <optional>

namespace course {

// The shares of unpolarised light that a boundary mirrors and lets through.
struct Shares {
    double reflected, transmitted;
};

struct Task {
    std::optional<Vec<double>> (*bent)(const Vec<double> &, const Vec<double> &, double, double);
    Shares (*divided)(double, double, double);
};

} // namespace course
