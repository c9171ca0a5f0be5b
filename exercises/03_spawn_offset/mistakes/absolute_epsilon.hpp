// Mistake: a constant offset. It is too small for a planet and too large for a grain of sand.
// Caught by: at every scale
#pragma once
#include "exercises/03_spawn_offset/task.hpp"

#include <cmath>

namespace course::exercise {

inline Ray<double> leaving(const Vec<double> &point, const Vec<double> &normal, const Vec<double> &direction,
                           const Sphere<float> &sphere) {
    (void)sphere;
    const double bound = 1e-7;
    const double side = dot(direction, normal) < 0 ? -1 : 1;
    return {point + side * bound * normal, direction};
}

inline constexpr Task task{leaving};

} // namespace course::exercise
