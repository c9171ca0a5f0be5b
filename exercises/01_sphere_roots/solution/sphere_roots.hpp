// Exercise 01, solved: where a ray meets a sphere.
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
    const double q = b < 0 ? root - b : -(root + b); // adds two numbers of the same sign
    const double near = b < 0 ? c / q : q / a, far = b < 0 ? q / a : c / q;
    for (const double t : {near, far})
        if (in_range(ray, t))
            return t;
    return {};
}

inline constexpr Task task{sphere_hit};

} // namespace course::exercise
