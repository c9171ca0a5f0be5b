// Exercise 10, the second: what an answer hands over.
#pragma once
#include "chapters/02_primitives/box.hpp"
#include "chapters/08_mesh/triangle.hpp"
#include "exercises/grading/not_done.hpp"

namespace course {

struct Task {
    bool (*overlaps)(const Triangle<float> &, const Box<double> &);
};

} // namespace course
