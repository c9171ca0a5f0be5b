// Mistake: the direction is taken to have length one, so a = d · d is left out.
// Caught by: the direction may have any length
#pragma once
#include "exercises/01_sphere_roots/task.hpp"

namespace course::exercise {

inline std::optional<double> sphere_hit(const Ray<double> &ray, const Sphere<float> &sphere) {
    const Vec<double> from_centre = ray.origin - Vec<double>(sphere.centre);
    const double radius = static_cast<double>(sphere.radius);
    const double b = dot(from_centre, ray.direction);
    const double c = dot(from_centre, from_centre) - radius * radius;
    const double discriminant = b * b - c;
    if (!(discriminant >= 0))
        return {};
    const double root = std::sqrt(discriminant);
    for (const double t : {-b - root, -b + root})
        if (in_range(ray, t))
            return t;
    return {};
}

inline constexpr Task task{sphere_hit};

} // namespace course::exercise
