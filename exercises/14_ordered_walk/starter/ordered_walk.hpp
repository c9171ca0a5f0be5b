// Exercise 14: the nearest hit in a BVH, with as little work as possible. README.md says what is asked.
#pragma once
#include "exercises/14_ordered_walk/task.hpp"

namespace course::exercise {

inline Hit<double> nearest(const Ray<double> &ray, const WalkTree &tree) {
    not_done(ray, tree); // put your own lines in place of this one
}

inline constexpr Task task{nearest}; // hands your function to the grader: leave it as it is

} // namespace course::exercise
