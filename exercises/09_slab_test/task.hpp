// Exercise 09: what an answer hands over.
#pragma once
#include "chapters/02_primitives/box.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

struct Task {
    bool (*meets_box)(const Ray<double> &, const Box<float> &);
};

} // namespace course
