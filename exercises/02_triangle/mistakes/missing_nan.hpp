// Mistake: the comparisons reject instead of accepting. For a ray in the plane t is 0 / 0; NaN makes all of them false,
// and a hit is reported. Caught by: a ray along the plane, or a triangle without area: no hit
#pragma once
#include "exercises/02_triangle/task.hpp"

#include <cmath>

namespace course::exercise {

inline ReadyTriangle make_ready(const Vec<float> &a, const Vec<float> &b, const Vec<float> &c) {
    const Vec<double> e1 = Vec<double>(b) - Vec<double>(a), e2 = Vec<double>(c) - Vec<double>(a);
    const Vec<double> normal = cross(e1, e2);
    const double area_squared = dot(normal, normal);
    return {Vec<double>(a), normal, cross(e2, normal) / area_squared, cross(normal, e1) / area_squared};
}

inline std::optional<double> triangle_hit(const Ray<double> &ray, const ReadyTriangle &triangle) {
    const double t = dot(triangle.normal, triangle.corner - ray.origin) / dot(triangle.normal, ray.direction);
    const Vec<double> from_corner = ray.origin + t * ray.direction - triangle.corner;
    const double u = dot(triangle.k1, from_corner), v = dot(triangle.k2, from_corner);
    if (u < 0 || v < 0 || u + v > 1 || t <= ray.t_min || t >= ray.t_max)
        return {};
    return t;
}

inline constexpr Task task{make_ready, triangle_hit};

} // namespace course::exercise
