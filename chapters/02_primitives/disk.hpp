// Lesson 02, step 2: the disk, a plane with a rim.
#pragma once
#include "chapters/02_primitives/flat_guarded.hpp"
#include "chapters/02_primitives/plane.hpp"

namespace course {

// The normal may have any length but zero. The rim belongs to the disk.
template <class S = float> struct Disk {
    Vec<S> centre, normal;
    S radius;
};

// The distance from the centre is measured at the t in double, before t is rounded to the ray's scalar.
template <class T, class S> std::optional<T> intersect_double(const Ray<T> &ray, const Disk<S> &disk) {
    const double t = plane_parameter(ray, disk.centre, Vec<double>(disk.normal));
    const Vec<double> from_centre =
        (Vec<double>(ray.origin) - Vec<double>(disk.centre)) + t * Vec<double>(ray.direction);
    const double radius = static_cast<double>(disk.radius);
    if (!(dot(from_centre, from_centre) <= radius * radius) || !in_range(ray, static_cast<T>(t)))
        return {};
    return static_cast<T>(t);
}

// A eq. 16 and 33, in the ray's scalar throughout, with the note's open rim.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const Disk<S> &disk) {
    const auto t = intersect_textbook(ray, Plane<S>{disk.centre, disk.normal});
    if (!t)
        return {};
    const Vec<T> from_centre = point_at(ray, *t) - Vec<T>(disk.centre);
    const T radius = static_cast<T>(disk.radius);
    if (!(dot(from_centre, from_centre) < radius * radius))
        return {};
    return t;
}

template <class T, class S> Surface<T, Disk<S>> surface(const Ray<T> &ray, T t, const Disk<S> &disk) {
    const Vec<T> normal = normalize(Vec<T>(disk.normal));
    return {onto_plane(point_at(ray, t), Vec<T>(disk.centre), normal), normal, disk};
}

} // namespace course
