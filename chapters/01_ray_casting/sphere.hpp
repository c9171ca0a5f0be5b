// Lesson 01, step 3: where a ray meets a sphere, by the textbook and by a form that does not cancel.
#pragma once
#include "chapters/01_ray_casting/sphere_guarded.hpp"
#include "chapters/01_ray_casting/surface.hpp"

#include <cmath>
#include <optional>

namespace course {

// S is the scalar that is stored. The radius is positive.
template <class S = float> struct Sphere {
    Vec<S> centre;
    S radius;
};

// The textbook quadratic, computed in the ray's scalar throughout: a t² + 2 b t + c = 0 (B §3). In float it loses a
// distant sphere, because b² and a c agree in their leading digits and their difference keeps only noise.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const Sphere<S> &sphere) {
    const Vec<T> from_centre = ray.origin - Vec<T>(sphere.centre);
    const T radius = static_cast<T>(sphere.radius);
    const T a = dot(ray.direction, ray.direction);
    const T b = dot(from_centre, ray.direction);
    const T c = dot(from_centre, from_centre) - radius * radius;
    const T discriminant = b * b - a * c;
    if (!(discriminant >= 0))
        return {};
    const T root = std::sqrt(discriminant);
    for (const T t : {(-b - root) / a, (-b + root) / a})
        if (in_range(ray, t))
            return t;
    return {};
}

// The cross-product form (A eq. 23), in double inside whatever the ray's scalar is. (intersect() itself, which knows
// the errors of what it computes, is in sphere_guarded.hpp.) The discriminant is r² |d|² - |(c - o) x d|², where the
// cross product measures the miss distance directly; of the two roots the one that would cancel is taken from the
// product of the roots, c / a.
template <class T, class S> std::optional<T> intersect_cross_product(const Ray<T> &ray, const Sphere<S> &sphere) {
    const Vec<double> direction(ray.direction), to_centre = Vec<double>(sphere.centre) - Vec<double>(ray.origin);
    const double radius = static_cast<double>(sphere.radius);
    const double a = dot(direction, direction);
    const double b = dot(to_centre, direction);
    const Vec<double> miss = cross(to_centre, direction);
    const double discriminant = radius * radius * a - dot(miss, miss);
    if (!(discriminant >= 0))
        return {};
    const double root = std::sqrt(discriminant);
    const double c = dot(to_centre, to_centre) - radius * radius;
    const double sum = b >= 0 ? b + root : b - root; // adds two numbers of the same sign
    const double near = b >= 0 ? c / sum : sum / a, far = b >= 0 ? sum / a : c / sum;
    for (const double root_t : {near, far})
        if (const T t = static_cast<T>(root_t); in_range(ray, t))
            return t;
    return {};
}

// The point is the hit moved along the normal onto the sphere, which takes the rounding of t back (A eq. 28).
template <class T, class S> Surface<T, Sphere<S>> surface(const Ray<T> &ray, T t, const Sphere<S> &sphere) {
    const Vec<T> centre(sphere.centre);
    const Vec<T> normal = normalize(point_at(ray, t) - centre);
    return {centre + static_cast<T>(sphere.radius) * normal, normal, sphere};
}

} // namespace course
