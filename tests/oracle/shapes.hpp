// The oracle asked about the course's own shapes: exact::answer(ray, shape).
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/08_mesh/triangle.hpp"
#include "tests/oracle/oracle.hpp"

namespace course::exact {

// The same ray in double, which changes none of its numbers.
template <class T> Line widened(const Ray<T> &ray) {
    return {Vec<double>(ray.origin), Vec<double>(ray.direction), static_cast<double>(ray.t_min),
            static_cast<double>(ray.t_max)};
}

template <class S> Answer answer(const Line &ray, const Sphere<S> &s) {
    return sphere(ray, Point(s.centre), static_cast<double>(s.radius));
}
template <class S> Answer answer(const Line &ray, const Plane<S> &s) {
    return plane(ray, Point(s.point), Vec<double>(s.normal));
}
template <class S> Answer answer(const Line &ray, const Disk<S> &s) {
    return disk(ray, Point(s.centre), Vec<double>(s.normal), static_cast<double>(s.radius));
}
// One without area has no finite k1, and is never hit.
template <class S> Answer answer(const Line &ray, const AffineTriangle<S> &s) {
    const Vec<double> k1(s.k1), k2(s.k2), normal(s.normal);
    if (!(dot(k1, k1) + dot(k2, k2) + dot(normal, normal) < infinity<double>))
        return {};
    return affine_triangle(ray, Point(s.corner), Vec<double>(s.normal), Vec<double>(s.k1), Vec<double>(s.k2));
}
template <class S> Answer answer(const Line &ray, const Triangle<S> &s) {
    return triangle(ray, Point(s.a), Point(s.b), Point(s.c));
}
template <class S> Answer answer(const Line &ray, const Box<S> &s) { return box(ray, Point(s.lo), Point(s.hi)); }
template <class S> Answer answer(const Line &ray, const Cylinder<S> &s) {
    return cylinder(ray, Point(s.bottom), Point(s.top), static_cast<double>(s.radius));
}
template <class S> Answer answer(const Line &ray, const Cone<S> &s) {
    return cone(ray, Point(s.apex), Point(s.base), static_cast<double>(s.radius));
}

} // namespace course::exact
