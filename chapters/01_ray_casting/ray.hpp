// Lesson 01, step 1: the ray, the one object that every later chapter traces.
#pragma once
#include "common/vectors.hpp"

#include <limits>

namespace course {

template <class T> inline constexpr T infinity = std::numeric_limits<T>::infinity();

// Counts nothing and costs nothing. Chapter 09 puts a ray with real counters in its place.
struct NoCounts {
    static constexpr void node() {}
    static constexpr void test() {}
};

// The points origin + t direction with t_min < t < t_max. T is the scalar that intersections are computed in; double,
// the default, keeps the origin of a bounced ray exact enough that it neither sticks to its surface nor leaks through.
// The direction need not have length one, and t counts in units of its length.
template <class T = double> struct Ray {
    using Scalar = T;

    Vec<T> origin, direction;
    T t_min = 0, t_max = infinity<T>;

    static constexpr NoCounts counts() { return {}; }
};

// The point of the ray at t (A eq. 1).
template <class T> Vec<T> point_at(const Ray<T> &ray, T t) { return ray.origin + t * ray.direction; }

// Whether a hit at t counts: strictly inside the ray's interval. False for NaN.
template <class T> bool in_range(const Ray<T> &ray, T t) { return t > ray.t_min && t < ray.t_max; }

} // namespace course
