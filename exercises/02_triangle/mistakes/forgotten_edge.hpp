// Mistake: the third edge, u + v <= 1, is forgotten, so the triangle becomes a quarter of the plane.
// Caught by: rays through the triangle meet it, rays beside it do not
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
    if (!(u >= 0 && v >= 0) || !in_range(ray, t))
        return {};
    return t;
}

inline constexpr Task task{make_ready, triangle_hit};

} // namespace course::exercise
