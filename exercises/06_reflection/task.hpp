// Exercise 06: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"

#include <functional>
#include <optional>

namespace course {

// What a ray meets first: the point, the normal there (of length one, to either side), the light that the place itself
// sends out, and the share of the arriving light that it mirrors, per channel.
struct Met {
    Vec<double> point, normal;
    Colour glow, share;
};

// The scene: what this ray meets, or nothing. A ray may start at a point that was met; the scene takes care of that.
using Meet = std::function<std::optional<Met>(const Ray<double> &)>;

struct Task {
    Vec<double> (*mirrored)(const Vec<double> &, const Vec<double> &);
    Colour (*light_along)(Ray<double>, const Meet &, int);
};

} // namespace course
