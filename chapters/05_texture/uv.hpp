// Lesson 05, step 2: where on a shape a point lies, as two numbers that a picture can be looked up with.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/02_primitives/plane.hpp"
#include "chapters/05_texture/frame.hpp"

#include <algorithm>

namespace course {

// u runs to the right and v upwards, both from 0 to 1 over a picture; beyond, pictures repeat.
using Uv = glm::vec<2, double, glm::defaultp>;

// How far round the axis a direction points, 0 at e0 and on towards e1: 0 <= u < 1. The arctangent of both coordinates
// is as exact everywhere; the arc cosine of note A (eq. 32, 39, 45) loses half its digits near e0 and needs two cases.
inline double turn(const Vec<double> &direction, const Frame &frame) {
    const double u = std::atan2(dot(direction, frame.e1), dot(direction, frame.e0)) / (2 * pi);
    const double wrapped = u < 0 ? u + 1 : u;
    return wrapped < 1 ? wrapped : 0;
}

// Longitude and latitude of a direction about the vertical axis (A eq. 6): v is 0 at the south pole, 1 at the north.
inline Uv spherical_uv(const Vec<double> &direction) {
    const double from_north = std::atan2(std::hypot(direction.x, direction.z), direction.y);
    return {turn(direction, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}), 1 - from_north / pi};
}

template <class S, class T> Uv uv(const Sphere<S> &sphere, const Vec<T> &point) {
    return spherical_uv(Vec<double>(point) - Vec<double>(sphere.centre));
}

// In lengths of the scene, from the plane's point: a plane has no end that could be 1.
template <class S, class T> Uv uv(const Plane<S> &plane, const Vec<T> &point) {
    const Frame frame = frame_around(Vec<double>(plane.normal));
    const Vec<double> d = Vec<double>(point) - Vec<double>(plane.point);
    return {dot(d, frame.e0), dot(d, frame.e1)};
}

// The square around the disk (A eq. 7).
template <class S, class T> Uv uv(const Disk<S> &disk, const Vec<T> &point) {
    const Frame frame = frame_around(Vec<double>(disk.normal));
    const Vec<double> d = (Vec<double>(point) - Vec<double>(disk.centre)) / (2 * static_cast<double>(disk.radius));
    return {dot(d, frame.e0) + 0.5, dot(d, frame.e1) + 0.5};
}

// The affine coordinates (u', v') of A eq. 19: (0, 0) at the first corner, (1, 0) and (0, 1) at the others. Placed
// (texture.hpp) carries them on to the corners' places in a picture, which is A eq. 5.
template <class S, class T> Uv uv(const AffineTriangle<S> &triangle, const Vec<T> &point) {
    const Vec<double> d = Vec<double>(point) - Vec<double>(triangle.corner);
    return {dot(Vec<double>(triangle.k1), d), dot(Vec<double>(triangle.k2), d)};
}

// Round and along an axis that starts at `foot`: u is the turn, v is 0 at the foot and 1 at its other end.
inline Uv uv_along(const Vec<double> &foot, const Vec<double> &axis, const Vec<double> &point) {
    const Vec<double> d = point - foot;
    return {turn(d, frame_around(axis)), dot(d, axis) / dot(axis, axis)};
}

// A eq. 10: v from the bottom to the top.
template <class S, class T> Uv uv(const Cylinder<S> &cylinder, const Vec<T> &point) {
    const Vec<double> bottom(cylinder.bottom);
    return uv_along(bottom, Vec<double>(cylinder.top) - bottom, Vec<double>(point));
}

// A eq. 13: v from the base to the apex.
template <class S, class T> Uv uv(const Cone<S> &cone, const Vec<T> &point) {
    const Vec<double> base(cone.base);
    return uv_along(base, Vec<double>(cone.apex) - base, Vec<double>(point));
}

// Each face is a whole picture, seen upright from outside; the top and the bottom have x to the right. The point
// belongs to the face that it is nearest to, which no flat box can divide by zero.
template <class S, class T> Uv uv(const Box<S> &box, const Vec<T> &point) {
    const Vec<double> lo(box.lo), hi(box.hi), p(point);
    Vec<double> normal(0);
    double nearest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const double distance = std::abs(p[axis] - (side < 0 ? lo : hi)[axis]);
            if (distance < nearest) {
                nearest = distance;
                normal = Vec<double>(0);
                normal[axis] = side;
            }
        }
    const Frame frame = frame_around(normal);
    const auto share = [&](const Vec<double> &along) {
        const double extent = std::abs(dot(hi - lo, along));
        return extent > 0 ? dot(p - 0.5 * (lo + hi), along) / extent + 0.5 : 0.5;
    };
    return {share(frame.e0), share(frame.e1)};
}

// What textures ask. A shape that finds its coordinates by the primitive's number (chapter 08's meshes) has its own
// overload of this one.
template <class T, class Shape> Uv uv(const Surface<T, Shape> &surface) { return uv(surface.shape, surface.point); }

} // namespace course
