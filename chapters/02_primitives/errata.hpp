// Lesson 02, beside the way: formulas as the notes print them. They are wrong, on purpose; the tests show how, and
// nothing else uses them.
#pragma once
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"

#include <utility>

namespace course {

// A eq. 34-38 as printed, with a = 1 - (n0 · n) where the expansion gives 1 - (n0 · n)². As in the note, the ray's
// direction must have length one.
template <class T, class S> std::optional<T> intersect_as_printed(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    const Vec<T> bottom(cylinder.bottom), axis = Vec<T>(cylinder.top) - bottom, d = ray.origin - bottom;
    const T l = length(axis), r = static_cast<T>(cylinder.radius);
    const Vec<T> n = axis / l, j = d - dot(n, d) * n;
    const T a = 1 - dot(ray.direction, n), b = dot(ray.direction, j), c = r * r - dot(d, j);
    const T root = std::sqrt(b * b + a * c);
    for (const T t : {(-b - root) / a, (-b + root) / a}) {
        const T z = dot(d, n) + dot(ray.direction, n) * t;
        if (z >= 0 && z <= l && in_range(ray, t))
            return t;
    }
    return {};
}

// The two roots of A eq. 42 in the order in which it lists them, with a = (n0 · n) - cos² as eq. 40 prints it or with
// the square that the expansion gives. The direction must have length one.
template <class T, class S>
std::pair<T, T> cone_roots_as_printed(const Ray<T> &ray, const Cone<S> &cone, bool with_the_square) {
    const Vec<T> apex(cone.apex), axis = Vec<T>(cone.base) - apex, d = ray.origin - apex;
    const T height = length(axis), r = static_cast<T>(cone.radius);
    const Vec<T> n = axis / height;
    const T cos_squared = height * height / (height * height + r * r), dn = dot(ray.direction, n);
    const Vec<T> j = dot(d, n) * n - cos_squared * d;
    const T a = (with_the_square ? dn * dn : dn) - cos_squared, b = dot(j, ray.direction), c = dot(j, d);
    const T root = std::sqrt(b * b - a * c);
    return {(-b - root) / a, (-b + root) / a};
}

// Whether the ray's point at t lies between apex and rim: A eq. 12.
template <class T, class S> bool between_apex_and_rim(const Ray<T> &ray, T t, const Cone<S> &cone) {
    const Vec<T> apex(cone.apex), axis = Vec<T>(cone.base) - apex;
    const T z = dot(point_at(ray, t) - apex, axis);
    return z >= 0 && z <= dot(axis, axis);
}

// A eq. 40-42 as printed.
template <class T, class S> std::optional<T> intersect_as_printed(const Ray<T> &ray, const Cone<S> &cone) {
    const auto [t1, t2] = cone_roots_as_printed(ray, cone, false);
    for (const T t : {t1, t2})
        if (in_range(ray, t) && between_apex_and_rim(ray, t, cone))
            return t;
    return {};
}

// The right roots; but the nearest is chosen first, and eq. 12 asked of it alone.
template <class T, class S> std::optional<T> intersect_nearest_first(const Ray<T> &ray, const Cone<S> &cone) {
    const auto [t1, t2] = cone_roots_as_printed(ray, cone, true);
    const T near = std::min(t1, t2), far = std::max(t1, t2), t = in_range(ray, near) ? near : far;
    return in_range(ray, t) && between_apex_and_rim(ray, t, cone) ? std::optional(t) : std::nullopt;
}

// The same, believing that t1 of eq. 42 is always the nearer root, which it is not where a < 0.
template <class T, class S> std::optional<T> intersect_first_root_first(const Ray<T> &ray, const Cone<S> &cone) {
    const auto [t1, t2] = cone_roots_as_printed(ray, cone, true);
    const T t = in_range(ray, t1) ? t1 : t2;
    return in_range(ray, t) && between_apex_and_rim(ray, t, cone) ? std::optional(t) : std::nullopt;
}

} // namespace course
