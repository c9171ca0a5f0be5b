// Lesson 02, step 1: the plane, one division, and the mother of every flat shape.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/02_primitives/flat_guarded.hpp"

#include <optional>

namespace course {

// All points p with normal · (p - point) = 0. The normal may have any length but zero; it says which side is outside.
template <class S = float> struct Plane { Vec<S> point, normal; };

// Where a ray meets the plane through `point`, in double: not finite where the ray runs along the plane. The plane's
// equation n · p + W = 0 is never used: far from the origin, n · o and W are large and their sum is noise, while the
// difference point - o is small and nearly exact.
template <class T, class S> double plane_parameter(const Ray<T> &ray, const Vec<S> &point, const Vec<double> &normal) {
    const Vec<double> to_point = Vec<double>(point) - Vec<double>(ray.origin);
    return dot(normal, to_point) / dot(normal, Vec<double>(ray.direction));
}

// in_range() is false for the infinite or undefined t of a parallel ray, so a ray within the plane misses it.
template <class T, class S> std::optional<T> intersect_double(const Ray<T> &ray, const Plane<S> &plane) {
    const T t = static_cast<T>(plane_parameter(ray, plane.point, Vec<double>(plane.normal)));
    if (!in_range(ray, t))
        return {};
    return t;
}

// A eq. 16, in the ray's scalar throughout: the plane as n · p + W = 0.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const Plane<S> &plane) {
    const Vec<T> normal(plane.normal);
    const T w = -dot(normal, Vec<T>(plane.point));
    const T t = -(dot(normal, ray.origin) + w) / dot(normal, ray.direction);
    if (!in_range(ray, t))
        return {};
    return t;
}

// The point nearest to p in the plane through `point` with the unit normal.
template <class T> Vec<T> onto_plane(const Vec<T> &p, const Vec<T> &point, const Vec<T> &normal) {
    return p - dot(p - point, normal) * normal;
}

template <class T, class S> Surface<T, Plane<S>> surface(const Ray<T> &ray, T t, const Plane<S> &plane) {
    const Vec<T> normal = normalize(Vec<T>(plane.normal));
    return {onto_plane(point_at(ray, t), Vec<T>(plane.point), normal), normal, plane};
}

} // namespace course
