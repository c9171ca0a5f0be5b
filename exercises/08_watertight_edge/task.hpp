// Exercise 08: what an answer hands over.
#pragma once
#include "exercises/grading/not_done.hpp"

namespace course {

// A corner of a triangle as the ray sees it: the ray runs through (0, 0).
struct Corner {
    double x, y;
};

struct Task {
    bool (*holds_ray)(const Corner &, const Corner &, const Corner &);
};

} // namespace course
