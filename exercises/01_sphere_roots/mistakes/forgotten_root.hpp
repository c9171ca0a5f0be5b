// Mistake: only the near root is tried, so whoever stands inside a sphere does not see it.
// Caught by: from inside, the far side is met
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
    const double t = (-b - std::sqrt(discriminant)) / a;
    if (in_range(ray, t))
        return t;
    return {};
}

inline constexpr Task task{sphere_hit};

} // namespace course::exercise
