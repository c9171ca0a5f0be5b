// Lesson 08, steps 1 and 2: the test of Möller and Trumbore (1997), as the notes print it and with its edges repaired.
#pragma once
#include "chapters/08_mesh/triangle.hpp"

#include <optional>

namespace course {

// Where the ray meets the triangle's plane: o + t d = (1 - b1 - b2) a + b1 b + b2 c. Three numbers, three equations,
// solved by Cramer's rule (B §3). Infinite or NaN for a ray along the plane.
template <class T> struct Barycentric { T t, b1, b2; };

// In the ray's scalar throughout. No determinant is too small: whether one is depends on the mesh's scale.
template <class T, class S> Barycentric<T> barycentric(const Ray<T> &ray, const Triangle<S> &triangle) {
    const Vec<T> a(triangle.a), e1 = Vec<T>(triangle.b) - a, e2 = Vec<T>(triangle.c) - a;
    const Vec<T> p = cross(ray.direction, e2), s = ray.origin - a, q = cross(s, e1);
    const T inverse = 1 / dot(p, e1);
    return {inverse * dot(q, e2), inverse * dot(p, s), inverse * dot(q, ray.direction)};
}

// As printed in B and C: inside where b1, b2 and 1 - b1 - b2 are > 0. A ray through an edge hits neither neighbour.
template <class T, class S> std::optional<T> moller_trumbore_strict(const Ray<T> &ray, const Triangle<S> &triangle) {
    const auto [t, b1, b2] = barycentric(ray, triangle);
    if (!(b1 > 0 && b2 > 0 && 1 - b1 - b2 > 0) || !in_range(ray, t))
        return {};
    return t;
}

// With the edges: a ray through one hits both neighbours or, where rounding so decides, still neither.
template <class T, class S> std::optional<T> moller_trumbore(const Ray<T> &ray, const Triangle<S> &triangle) {
    const auto [t, b1, b2] = barycentric(ray, triangle);
    if (!(b1 >= 0 && b2 >= 0 && b1 + b2 <= 1) || !in_range(ray, t))
        return {};
    return t;
}

} // namespace course
