// Exercise 02: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"

#include <optional>

namespace course {

// A triangle made ready: a corner, a normal of any length, and the two vectors that give a point's coordinates in the
// triangle, u = k1 · (p - corner) and v = k2 · (p - corner).
struct ReadyTriangle {
    Vec<double> corner, normal, k1, k2;
};

struct Task {
    ReadyTriangle (*make_ready)(const Vec<float> &, const Vec<float> &, const Vec<float> &);
    std::optional<double> (*triangle_hit)(const Ray<double> &, const ReadyTriangle &);
};

} // namespace course
