// Exercise 03: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

struct Task {
    Ray<double> (*leaving)(const Vec<double> &, const Vec<double> &, const Vec<double> &, const Sphere<float> &);
};

} // namespace course
