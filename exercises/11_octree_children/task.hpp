// Exercise 11: what an answer hands over.
#pragma once
#include "chapters/02_primitives/box.hpp"
#include "exercises/grading/not_done.hpp"

#include <vector>

namespace course {

struct Task {
    std::vector<int> (*children_met)(const Ray<double> &, const Box<double> &);
};

} // namespace course
