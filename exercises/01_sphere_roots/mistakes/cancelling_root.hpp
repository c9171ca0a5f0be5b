// Mistake: both roots by the school formula. Close above the surface -b and the square root are nearly equal, and
// little is left of their difference.
// Caught by: close to the surface no digits are lost
#pragma once
#include "exercises/01_sphere_roots/task.hpp"

namespace course::exercise {

inline std::optional<double> sphere_hit(const Ray<double> &ray, const Sphere<float> &sphere) {
    const Vec<double> from_centre = ray.origin - Vec<double>(sphere.centre);
    const double radius = static_cast<double>(sphere.radius);
    const double a = dot(ray.direction, ray.direction);
    const double b = dot(from_centre, ray.direction);
    const double c = dot(from_centre, from_centre) - radius * radius;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0))
        return {};
    const double root = std::sqrt(discriminant);
    for (const double t : {(-b - root) / a, (-b + root) / a})
        if (in_range(ray, t))
            return t;
    return {};
}

inline constexpr Task task{sphere_hit};

} // namespace course::exercise
