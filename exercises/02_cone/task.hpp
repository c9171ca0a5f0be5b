// Exercise 02: what an answer hands over.
#pragma once
#include "chapters/02_primitives/cone.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

struct Task {
    std::optional<double> (*cone_hit)(const Ray<double> &, const Cone<float> &);
};

} // namespace course
