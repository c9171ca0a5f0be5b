// Lesson 08, step 4b: t of a hit on a triangle that the ray nearly runs along, or that is seen from very far.
#pragma once
#include "chapters/02_primitives/flat_guarded.hpp"

#include <cmath>
#include <limits>

namespace course {

template <class S> struct Triangle;

// t from the triangle's plane in double-double; 0 where the ray runs along it or starts in it.
template <class T, class S>
[[gnu::noinline, gnu::cold]] double plane_t_in_doubt(const Ray<T> &ray, const Triangle<S> &triangle) {
    using N = DoubleDouble;
    const auto a = triple<N>(triangle.a);
    const auto normal = cross(triple<N>(triangle.b) - a, triple<N>(triangle.c) - a);
    return last_parameter(crossing(normal, a - triple<N>(ray.origin), triple<N>(ray.direction)));
}

// The t that the watertight test has seen, where the triangle's plane confirms it to within 2^-26 of itself; else the
// plane's own. NaN for a triangle without area. With t = gap / along in truth, |t along - gap| is what t is off by,
// times `along`, and both products carry errors of their own.
template <class T, class S> [[gnu::noinline]] double confirmed_t(const Ray<T> &ray, const Triangle<S> &triangle,
                                                                 const Vec<double> &area, double t) {
    if (area == Vec<double>(0))
        return std::numeric_limits<double>::quiet_NaN();
    const auto met = crossing(triple<double>(area), triple<double>(triangle.a) - triple<double>(ray.origin),
                              triple<double>(ray.direction));
    const double off = std::abs(t * met.along - met.gap) + std::abs(t) * met.along_error + met.gap_error;
    return off <= 0x1p-26 * std::abs(met.gap) ? t : plane_t_in_doubt(ray, triangle);
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template double plane_t_in_doubt(const Ray<double> &, const Triangle<float> &);
#endif

} // namespace course
