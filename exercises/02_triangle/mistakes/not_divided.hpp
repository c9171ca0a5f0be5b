// Mistake: k1 and k2 point the right way, but are not divided by |N|², so u and v are not 1 at the corners.
// Caught by: k1 and k2 read off u and v
#pragma once
#include "exercises/02_triangle/task.hpp"

#include <cmath>

namespace course::exercise {

inline ReadyTriangle make_ready(const Vec<float> &a, const Vec<float> &b, const Vec<float> &c) {
    const Vec<double> e1 = Vec<double>(b) - Vec<double>(a), e2 = Vec<double>(c) - Vec<double>(a);
    const Vec<double> normal = cross(e1, e2);
    return {Vec<double>(a), normal, cross(e2, normal), cross(normal, e1)};
}

inline std::optional<double> triangle_hit(const Ray<double> &ray, const ReadyTriangle &triangle) {
    const double t = dot(triangle.normal, triangle.corner - ray.origin) / dot(triangle.normal, ray.direction);
    const Vec<double> from_corner = ray.origin + t * ray.direction - triangle.corner;
    const double u = dot(triangle.k1, from_corner), v = dot(triangle.k2, from_corner);
    if (!(u >= 0 && v >= 0 && u + v <= 1) || !in_range(ray, t))
        return {};
    return t;
}

inline constexpr Task task{make_ready, triangle_hit};

} // namespace course::exercise
