// Lesson 03, step 4: where a new ray starts, so that it neither meets its own surface again nor slips past a neighbour.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"

#include <cmath>

namespace course {

inline double norm_1(const Vec<double> &v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// How far a point of a surface, worked out in double, can lie from where it should: some 8 roundings of 2^-53, each of
// a number no larger than the coordinates around. 2^-48 leaves room for 32.
inline double rounding_bound(const Vec<double> &point, const Vec<double> &reference, double size = 0) {
    return 0x1p-48 * (norm_1(point) + norm_1(reference) + size);
}

// The bound for a point of a shape. Every shape that rays start from has an overload.
template <class S> double spawn_offset(const Sphere<S> &sphere, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(sphere.centre), static_cast<double>(sphere.radius));
}
template <class S> double spawn_offset(const Plane<S> &plane, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(plane.point));
}
template <class S> double spawn_offset(const Disk<S> &disk, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(disk.centre));
}
template <class S> double spawn_offset(const AffineTriangle<S> &triangle, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(triangle.corner));
}
template <class S> double spawn_offset(const Cylinder<S> &cylinder, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(cylinder.bottom), norm_1(Vec<double>(cylinder.top)) + cylinder.radius);
}
template <class S> double spawn_offset(const Cone<S> &cone, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(cone.apex), norm_1(Vec<double>(cone.base)) + cone.radius);
}
template <class S> double spawn_offset(const Box<S> &box, const Vec<double> &point) {
    return rounding_bound(point, Vec<double>(box.lo), norm_1(Vec<double>(box.hi)));
}

// The ray that leaves the surface in the direction (of any length): from the point that surface() has put on the shape,
// moved along the normal by the bound, to the side to which the ray goes. A plane or a convex shape then lies wholly
// behind a ray that leaves outwards, however flat it leaves; one that goes inwards starts strictly inside.
// The origin is double, whatever the scene stores: no float lies near enough to a concave edge.
template <class T, class Shape>
Ray<double> spawn_ray(const Surface<T, Shape> &surface, const Vec<double> &direction, double t_max = infinity<double>) {
    const Vec<double> point(surface.point), normal(surface.normal);
    const double offset = spawn_offset(surface.shape, point);
    return {point + (dot(direction, normal) < 0 ? -offset : offset) * normal, direction, 0, t_max};
}

// What a shade function is given to start rays with: the rule above ...
struct ExactSpawn {
    template <class T, class Shape>
    Ray<double> operator()(const Surface<T, Shape> &surface, const Vec<double> &direction, double t_max) const {
        return spawn_ray(surface, direction, t_max);
    }
};

// ... or note A's, for the experiment: step back on the incoming ray by a constant δ, in float as its shader computes
// (A eq. 49). Too small a δ and the surface shadows itself (acne); too large and light leaks past thin gaps.
struct ConstantOffset {
    Ray<float> incoming; // with a direction of length one, so that δ is a length
    float t, delta;

    template <class T, class Shape>
    Ray<float> operator()(const Surface<T, Shape> &, const Vec<double> &direction, double t_max) const {
        return {point_at(incoming, t - delta), Vec<float>(direction), 0, static_cast<float>(t_max)};
    }
};

} // namespace course
