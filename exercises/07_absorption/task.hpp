// Exercise 07: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"

#include <vector>

namespace course {

// A medium on the ray's way, up to t = end. The absorption is per unit length, not per unit of t.
struct Layer {
    double end;
    Colour absorption;
};

struct Task {
    Colour (*light_left)(const Ray<double> &, const std::vector<Layer> &);
};

} // namespace course
