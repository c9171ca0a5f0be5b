// Exercise 01: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

struct Task {
    std::optional<double> (*sphere_hit)(const Ray<double> &, const Sphere<float> &);
};

} // namespace course
