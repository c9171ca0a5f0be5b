// Lesson 09, step 3: other shapes to put around an object, a sphere and slabs in any direction, to compare the box
// with.
#pragma once
#include "chapters/09_aabb/bounds.hpp"

#include <array>

namespace course {

// Around the points: the centre of their box, and the distance to the farthest, rounded up.
inline Sphere<> bounding_sphere(std::span<const Vec<float>> points) {
    Box<float> box = empty_box();
    for (const Vec<float> &point : points)
        box = merge(box, Box<float>{point, point});
    Sphere<> sphere{Vec<float>(centre(box)), 0};
    double farthest = 0;
    for (const Vec<float> &point : points)
        farthest = std::max(farthest, length(Vec<double>(point) - Vec<double>(sphere.centre)));
    sphere.radius = rounded_up<float>(farthest * (1 + 0x1p-40));
    return sphere;
}

// Whether the ray meets the ball: it begins inside, or it passes near enough and the ball is not behind. Where the box
// needs six multiplications, this needs a cross product and up to four dot products, but no division and no comparison
// a face.
template <class T, class S> bool meets(const Ray<T> &ray, const Sphere<S> &ball) {
    const Vec<double> to_centre = Vec<double>(ball.centre) - Vec<double>(ray.origin), direction(ray.direction);
    const double radius_squared = static_cast<double>(ball.radius) * static_cast<double>(ball.radius);
    const Vec<double> miss = cross(to_centre, direction);
    const bool near_enough = dot(miss, miss) <= radius_squared * dot(direction, direction) * (1 + 0x1p-24);
    const bool inside = dot(to_centre, to_centre) <= radius_squared;
    return near_enough && (inside || dot(to_centre, direction) > 0);
}

// Three pairs of parallel planes in any directions, lo <= normal · p <= hi: a box that may be turned (and askew).
struct Slabs {
    std::array<Vec<double>, 3> normals;
    Vec<double> lo{infinity<double>}, hi{-infinity<double>};
};

inline Slabs slabs_around(std::span<const Vec<float>> points, const std::array<Vec<double>, 3> &normals) {
    Slabs slabs{normals};
    for (const Vec<float> &point : points) {
        const Vec<double> p(point), heights(dot(normals[0], p), dot(normals[1], p), dot(normals[2], p));
        slabs.lo = min(slabs.lo, heights);
        slabs.hi = max(slabs.hi, heights);
    }
    return slabs;
}

// For planes along the axes, normal · o and normal · d are just a component of each. Here they are two dot products a
// slab, and their quotient cannot be prepared once per ray: each box of a hierarchy would have normals of its own.
template <class T> bool meets(const Ray<T> &ray, const Slabs &slabs) {
    const Vec<double> origin(ray.origin), direction(ray.direction);
    double enter = static_cast<double>(ray.t_min), exit = static_cast<double>(ray.t_max);
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        const double o = dot(slabs.normals[i], origin), inverse = 1 / dot(slabs.normals[i], direction);
        const double t0 = (slabs.lo[axis] - o) * inverse, t1 = (slabs.hi[axis] - o) * inverse;
        enter = std::max(enter, std::min(t0, t1));
        exit = std::min(exit, std::max(t0, t1));
    }
    return enter <= exit * (1 + 0x1p-40);
}

// The same with planes along the axes, nothing prepared and no margin: what C20 compares the slabs with.
template <class T, class S> bool meets_plainly(const Ray<T> &ray, const Box<S> &box) {
    const Vec<double> origin(ray.origin), inverse = 1.0 / Vec<double>(ray.direction);
    double enter = static_cast<double>(ray.t_min), exit = static_cast<double>(ray.t_max);
    for (int axis = 0; axis < 3; ++axis) {
        const double t0 = (static_cast<double>(box.lo[axis]) - origin[axis]) * inverse[axis];
        const double t1 = (static_cast<double>(box.hi[axis]) - origin[axis]) * inverse[axis];
        enter = std::max(enter, std::min(t0, t1));
        exit = std::min(exit, std::max(t0, t1));
    }
    return enter <= exit * (1 + 0x1p-40);
}

} // namespace course
