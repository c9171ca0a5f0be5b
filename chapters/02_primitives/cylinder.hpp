// Lesson 02, step 5: the side of a cylinder.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/02_primitives/cylinder_guarded.hpp"
#include "chapters/02_primitives/quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace course {

// The side alone: its ends are open, and its two rims belong to it. Stored by the centres of its end circles, so that
// every set of floats is some cylinder exactly and the oracle of the tests judges the very same one.
template <class S = float> struct Cylinder {
    Vec<S> bottom, top;
    S radius;
};

// The cylinder by note A's parameters (A 3.1.8). The axis points from the bottom to the top and may have any length.
template <class S = float>
Cylinder<S> cylinder_along(const Vec<double> &centre, const Vec<double> &axis, double radius, double height) {
    return {Vec<S>(centre), Vec<S>(centre + height * normalize(axis)), static_cast<S>(radius)};
}

// With the axis n and m = o - bottom, points at distance r from the axis satisfy |(m + t d) x n|² = r² |n|². The
// discriminant is |n|² (r² |w|² - (m · w)²) with w = d x n: m · w / |w| is the distance between ray and axis, measured
// directly. A ray along the axis has a = b = 0 and no root; a ray within the side counts as a miss, as in a plane.
template <class T, class S> std::optional<T> intersect_cross_product(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    const Vec<double> d(ray.direction), bottom(cylinder.bottom);
    const Vec<double> n = Vec<double>(cylinder.top) - bottom, m = Vec<double>(ray.origin) - bottom;
    const double r = static_cast<double>(cylinder.radius), nn = dot(n, n);
    const Vec<double> w = cross(d, n), q = cross(m, n);
    const double discriminant = nn * (r * r * dot(w, w) - dot(m, w) * dot(m, w));
    if (!(discriminant >= 0))
        return {};

    // Each root in turn must lie between the rims, where 0 <= height <= |n|².
    for (const double root : roots(dot(w, w), dot(w, q), dot(q, q) - r * r * nn, discriminant)) {
        const double height = dot(m, n) + root * dot(d, n);
        if (const T t = static_cast<T>(root); height >= 0 && height <= nn && in_range(ray, t))
            return t;
    }
    return {};
}

// A eq. 34-38 with the square that eq. 34 lacks, in the ray's scalar throughout.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    const Vec<T> bottom(cylinder.bottom), axis = Vec<T>(cylinder.top) - bottom, m = ray.origin - bottom;
    const T l = length(axis), r = static_cast<T>(cylinder.radius);
    const Vec<T> n = axis / l, j = m - dot(n, m) * n;
    const T dn = dot(ray.direction, n);
    const T a = dot(ray.direction, ray.direction) - dn * dn, b = dot(ray.direction, j), c = dot(m, j) - r * r;
    const T discriminant = b * b - a * c;
    if (!(discriminant >= 0))
        return {};
    const T root = std::sqrt(discriminant);
    for (const T t : {(-b - root) / a, (-b + root) / a}) {
        const T z = dot(m, n) + dn * t;
        if (z >= 0 && z <= l && in_range(ray, t))
            return t;
    }
    return {};
}

// The normal points away from the axis; the point is moved along it onto the side, and between the rims.
template <class T, class S> Surface<T, Cylinder<S>> surface(const Ray<T> &ray, T t, const Cylinder<S> &cylinder) {
    const Vec<T> bottom(cylinder.bottom), n = Vec<T>(cylinder.top) - bottom, m = point_at(ray, t) - bottom;
    const T share = dot(m, n) / dot(n, n);
    const Vec<T> normal = normalize(m - share * n);
    return {bottom + std::clamp(share, T(0), T(1)) * n + static_cast<T>(cylinder.radius) * normal, normal, cylinder};
}

} // namespace course
