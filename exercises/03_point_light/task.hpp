// Exercise 03: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"

#include <functional>

namespace course {

// Shines alike in all directions. The intensity is what a white surface at distance one that faces the lamp sends out.
struct Lamp {
    Vec<double> position;
    Colour intensity;
};

// Whether the ray meets anything within its interval.
using Blocked = std::function<bool(const Ray<double> &)>;

struct Task {
    Colour (*lamp_light)(const Vec<double> &, const Vec<double> &, const Lamp &, const Blocked &);
};

} // namespace course
