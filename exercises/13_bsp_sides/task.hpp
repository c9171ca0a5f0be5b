// Exercise 13: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

// A plane through space: above it is where normal · p > offset.
struct CutPlane {
    Vec<double> normal;
    double offset;
};

// How a ray goes through a node: first the one side, from t_min, then perhaps the other, from `change` on.
struct Sides {
    bool first_above;
    bool both;
    double change; // counts only where both are visited
};

struct Task {
    Sides (*sides_met)(const Ray<double> &, const CutPlane &);
};

} // namespace course
