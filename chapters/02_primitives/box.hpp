// Lesson 02, step 7: the box, three pairs of parallel planes.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/02_primitives/box_guarded.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace course {

// All points with lo <= p <= hi in each coordinate. Flat boxes are boxes.
template <class S = float> struct Box { Vec<S> lo, hi; };

// A line parallel to a pair of planes either lies between them and is not limited by them, or misses; deciding that
// apart keeps 0 / 0 out of the comparisons. A box touched at an edge or a flat one has enter = exit (A 3.2.7, B §4).
template <class T, class S> Span span_within(const Ray<T> &ray, const Box<S> &box) {
    Span span;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = static_cast<double>(ray.origin[axis]), d = static_cast<double>(ray.direction[axis]);
        const double lo = static_cast<double>(box.lo[axis]), hi = static_cast<double>(box.hi[axis]);
        if (d == 0) {
            if (!(lo <= o && o <= hi))
                return {1, 0};
            continue;
        }
        const double at_lo = (lo - o) / d, at_hi = (hi - o) / d;
        span.enter = std::max(span.enter, std::min(at_lo, at_hi));
        span.exit = std::min(span.exit, std::max(at_lo, at_hi));
    }
    return span;
}

// The nearest face in the ray's interval: from inside, the one through which the ray leaves.
template <class T, class S> std::optional<T> intersect_double(const Ray<T> &ray, const Box<S> &box) {
    const Span span = span_within(ray, box);
    if (!(span.enter <= span.exit))
        return {};
    for (const double end : {span.enter, span.exit})
        if (const T t = static_cast<T>(end); in_range(ray, t))
            return t;
    return {};
}

// The slabs as B §4 and C print them, in the ray's scalar throughout: t_enter < t_exit loses flat boxes, and a ray that
// lies in the plane of a face meets 0 · infinity.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const Box<S> &box) {
    const Vec<T> inverse = T(1) / ray.direction;
    const Vec<T> t0 = (Vec<T>(box.lo) - ray.origin) * inverse, t1 = (Vec<T>(box.hi) - ray.origin) * inverse;
    const Vec<T> near = min(t0, t1), far = max(t0, t1);
    const T enter = std::max({near.x, near.y, near.z}), exit = std::min({far.x, far.y, far.z});
    if (!(enter < exit))
        return {};
    for (const T t : {enter, exit})
        if (in_range(ray, t))
            return t;
    return {};
}

// The face that was hit is the one whose plane the ray meets nearest to t; at an edge, the first in the order of the
// axes. The point lies on it exactly.
template <class T, class S> Surface<T, Box<S>> surface(const Ray<T> &ray, T t, const Box<S> &box) {
    const Vec<T> lo(box.lo), hi(box.hi);
    Vec<T> point = clamp(point_at(ray, t), lo, hi), normal(0);
    T best = infinity<T>, plane = 0;
    int face = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {ray.direction[axis] < 0, ray.direction[axis] >= 0}) { // the near face first
            const T coordinate = high ? hi[axis] : lo[axis];
            const T off = std::abs((coordinate - ray.origin[axis]) / ray.direction[axis] - t);
            if (off < best) {
                best = off;
                plane = coordinate;
                face = axis;
                normal = Vec<T>(0);
                normal[axis] = high ? T(1) : T(-1);
            }
        }
    point[face] = plane;
    return {point, normal, box};
}

} // namespace course
