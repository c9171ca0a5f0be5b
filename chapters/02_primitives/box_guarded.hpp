// Lesson 02, step 7b: the box's default test, guarded: two planes met at nearly the same t are put in order exactly.
#pragma once
#include "chapters/01_ray_casting/guarded.hpp"

#include <algorithm>

namespace course {

template <class S> struct Box;

// The part of a line within a box: from `enter` to `exit`; empty where enter > exit.
struct Span {
    double enter = -infinity<double>, exit = infinity<double>;
};
template <class T, class S> Span span_within(const Ray<T> &ray, const Box<S> &box);

// A t that is never divided out: numerator / denominator, the denominator positive.
struct Fraction {
    DoubleDouble numerator;
    double denominator;
};

inline bool surely_less(const Fraction &a, const Fraction &b) {
    const DoubleDouble left = a.numerator * b.denominator, right = b.numerator * a.denominator;
    return sure_sign(left - right, 0x1p-98 * (std::abs(left.high) + std::abs(right.high))) < 0;
}

template <class T, class S> [[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const Box<S> &box) {
    std::optional<Fraction> enter, exit;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = static_cast<double>(ray.origin[axis]), d = static_cast<double>(ray.direction[axis]);
        const double lo = static_cast<double>(box.lo[axis]), hi = static_cast<double>(box.hi[axis]);
        if (!(d > 0 || d < 0))
            continue; // span_within() has made sure that the ray runs between these planes
        const Fraction near = d > 0 ? Fraction{two_sum(lo, -o), d} : Fraction{two_sum(o, -hi), -d};
        const Fraction far = d > 0 ? Fraction{two_sum(hi, -o), d} : Fraction{two_sum(o, -lo), -d};
        if (!enter || surely_less(*enter, near))
            enter = near;
        if (!exit || surely_less(far, *exit))
            exit = far;
    }
    if (!enter || surely_less(*exit, *enter))
        return nowhere;
    const double at_enter = enter->numerator.high / enter->denominator;
    return static_cast<T>(at_enter) > ray.t_min ? at_enter : exit->numerator.high / exit->denominator;
}

// The span of a line that runs along no pair of planes, by three divisions instead of six. Each t is off by at most
// three roundings.
inline Span oblique_span(const Vec<double> &o, const Vec<double> &d, const Vec<double> &lo, const Vec<double> &hi) {
    const Vec<double> inverse = 1.0 / d, at_lo = (lo - o) * inverse, at_hi = (hi - o) * inverse;
    const Vec<double> near = min(at_lo, at_hi), far = max(at_lo, at_hi);
    return {std::max({near.x, near.y, near.z}), std::min({far.x, far.y, far.z})};
}

// Where the ray meets a face, from inside the one through which it leaves; or nowhere. Each end of the span is within
// 2^-51 of itself.
template <class T, class S> inline double nearest_t(const Ray<T> &ray, const Box<S> &box) {
    const Vec<double> d(ray.direction);
    const bool oblique = std::abs(d.x) > 0x1p-1000 && std::abs(d.y) > 0x1p-1000 && std::abs(d.z) > 0x1p-1000;
    const Span span = oblique ? oblique_span(Vec<double>(ray.origin), d, Vec<double>(box.lo), Vec<double>(box.hi))
                              : span_within(ray, box);
    const double slack = 0x1p-50 * std::max(std::abs(span.enter), std::abs(span.exit));
    if (span.enter > span.exit + slack)
        return nowhere;
    if (!(span.enter < span.exit - slack))
        return t_in_doubt(ray, box);
    return static_cast<T>(span.enter) > ray.t_min ? span.enter : span.exit;
}

// Exact hit or miss; t within an ulp of a float.
template <class T, class S> inline std::optional<T> intersect(const Ray<T> &ray, const Box<S> &box) {
    return hit_in_range(ray, nearest_t(ray, box));
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template double t_in_doubt(const Ray<double> &, const Box<float> &);
#endif

} // namespace course
