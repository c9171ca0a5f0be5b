// Mistake: the weight is lowered before the glow is added, so a mirror dims its own light.
// Caught by: without a mirror, a place shows its own light
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
        weight *= met->share;
        sum += weight * met->glow;
        if (bounce == bounces || weight == Colour(0))
            return sum;
        ray = {met->point, mirrored(ray.direction, met->normal)};
    }
}

inline constexpr Task task{mirrored, light_along};

} // namespace course::exercise
