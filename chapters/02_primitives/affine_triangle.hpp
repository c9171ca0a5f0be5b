// Lesson 02, step 3: the triangle as note A stores it, ready for a test of two dot products.
#pragma once
#include "chapters/02_primitives/flat_guarded.hpp"
#include "chapters/02_primitives/plane.hpp"

#include <array>

namespace course {

// The plane of the triangle, by its first corner and unit normal, and the two vectors that give a point's affine
// coordinates in it: p = corner + u e1 + v e2 with u = k1 · (p - corner), v = k2 · (p - corner) (A eq. 17-21). What is
// stored is rounded to S, so the edges lie where k1 and k2 say, within a rounding error of the corners that were given;
// chapter 08's triangle keeps the corners themselves. A triangle without area has no finite k1 and is never hit.
template <class S = float> struct AffineTriangle { Vec<S> corner, normal, k1, k2; };

// The triangle a, b, c, which winds counter-clockwise seen from outside: e1 = b - a, e2 = c - a.
template <class S> AffineTriangle<S> affine_triangle(const Vec<S> &a, const Vec<S> &b, const Vec<S> &c) {
    const Vec<double> e1 = Vec<double>(b) - Vec<double>(a), e2 = Vec<double>(c) - Vec<double>(a);
    const Vec<double> normal = cross(e1, e2);
    const double area_squared = dot(normal, normal);
    const Vec<double> k1 = cross(e2, normal) / area_squared, k2 = cross(normal, e1) / area_squared;
    return {a, Vec<S>(normalize(normal)), Vec<S>(k1), Vec<S>(k2)};
}

// The way back: k1 and k2 are to e1 and e2 what e1 and e2 are to k1 and k2.
template <class S> std::array<Vec<double>, 3> corners(const AffineTriangle<S> &triangle) {
    const Vec<double> a(triangle.corner), k1(triangle.k1), k2(triangle.k2), n = cross(k1, k2);
    return {a, a + cross(k2, n) / dot(n, n), a + cross(n, k1) / dot(n, n)};
}

// Edges belong to the triangle. The comparisons accept, so that a NaN is no hit.
template <class T, class S> std::optional<T> intersect_double(const Ray<T> &ray, const AffineTriangle<S> &triangle) {
    const double t = plane_parameter(ray, triangle.corner, Vec<double>(triangle.normal));
    const Vec<double> d = (Vec<double>(ray.origin) - Vec<double>(triangle.corner)) + t * Vec<double>(ray.direction);
    const double u = dot(Vec<double>(triangle.k1), d), v = dot(Vec<double>(triangle.k2), d);
    if (!(u >= 0 && v >= 0 && u + v <= 1) || !in_range(ray, static_cast<T>(t)))
        return {};
    return static_cast<T>(t);
}

// A eq. 16-22, in the ray's scalar throughout.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const AffineTriangle<S> &triangle) {
    const auto t = intersect_textbook(ray, Plane<S>{triangle.corner, triangle.normal});
    if (!t)
        return {};
    const Vec<T> d = point_at(ray, *t) - Vec<T>(triangle.corner);
    const T u = dot(Vec<T>(triangle.k1), d), v = dot(Vec<T>(triangle.k2), d);
    if (!(u >= 0 && v >= 0 && u + v <= 1))
        return {};
    return t;
}

template <class T, class S>
Surface<T, AffineTriangle<S>> surface(const Ray<T> &ray, T t, const AffineTriangle<S> &triangle) {
    const Vec<T> normal = normalize(Vec<T>(triangle.normal));
    return {onto_plane(point_at(ray, t), Vec<T>(triangle.corner), normal), normal, triangle};
}

} // namespace course
