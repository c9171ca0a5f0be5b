// Mistake: a ray is followed although it carries nothing.
// Caught by: a ray that carries nothing is not sent
#pragma once
#include "exercises/06_reflection/task.hpp"

#include <cmath>

namespace course::exercise {

inline Vec<double> mirrored(const Vec<double> &direction, const Vec<double> &normal) {
    return direction - 2 * dot(direction, normal) * normal;
}

inline Colour light_along(Ray<double> ray, const Meet &meet, int bounces) {
    Colour sum(0), weight(1);
    for (int bounce = 0;; ++bounce) {
        const std::optional<Met> met = meet(ray);
        if (!met)
            return sum;
        sum += weight * met->glow;
        weight *= met->share;
        if (bounce == bounces)
            return sum;
        ray = {met->point, mirrored(ray.direction, met->normal)};
    }
}

inline constexpr Task task{mirrored, light_along};

} // namespace course::exercise
