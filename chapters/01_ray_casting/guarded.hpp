// Lesson 01, step 7: a test that knows when it might be wrong. Numbers carry a bound of their rounding error; where the
// bound leaves a decision open, the same decision is made again with more digits.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "common/double_double.hpp"

#include <cmath>
#include <optional>
#include <type_traits>

namespace course {

// The t of a ray that is let pass. A guarded test hands bare numbers on, and makes an optional of one only at its very
// end: an optional that goes through several hands is copied through memory, which takes as long as the test itself.
inline constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

template <class T> std::optional<T> hit_in_range(const Ray<T> &ray, double t) {
    const T rounded = static_cast<T>(t);
    if (!in_range(ray, rounded))
        return {};
    return rounded;
}

// What one stage of a test found. Not sure: its digits leave the answer open, and a later stage must decide.
struct Decision {
    bool sure = false;
    double t = nowhere;
};

// Which of a number's signs is certain: 0 where the error bound reaches over zero, and for NaN.
template <class N> int sure_sign(const N &x, double error) {
    const double value = static_cast<double>(x);
    return value > error ? 1 : value < -error ? -1 : 0;
}

// With t off by less than 2^-25 of itself, a float t is off by less than one ulp: so each quotient's numerator and
// denominator must be this many times larger than its own error.
inline constexpr double clear_of_error = 0x1p27;

// Stage one for every shape with a quadratic: t = (-b ± root) / a with a > 0, the nearest in the ray's interval for
// which within(t) says 1 (-1: no, 0: too near to tell); t_max is left to the caller. For both signs, (-b ± root) root
// must be off by less than 2^-27 of `clear`, and a by less than 2^-27 of itself; where that leaves t or its sign open,
// in_doubt() answers.
template <class T, class Within, class InDoubt>
[[gnu::always_inline]] inline double nearest_of_two(const Ray<T> &ray, double a, double b, double root, double clear,
                                                    const Within &within, const InDoubt &in_doubt) {
    for (const double a_t : {-b - root, root - b}) {
        if (a_t * root < -clear)
            continue; // behind the origin
        if (!(a_t * root > clear))
            return in_doubt();
        const double t = a_t / a;
        const int place = within(t);
        if (place == 0)
            return in_doubt();
        if (place < 0)
            continue;
        if (const double polished = within.polished(t); static_cast<T>(polished) > ray.t_min)
            return polished;
    }
    return nowhere;
}

// a t² + 2 b t + c = 0 and its discriminant b² - a c, each within its error of the truth. The error of b must be below
// 2^-24 of the root of the discriminant's error.
template <class N> struct Quadratic {
    N a, b, c, discriminant;
    double a_error, b_error, c_error, discriminant_error;
};

// The nearest root t in the ray's interval for which within(t) says 1 (-1: no, 0: its digits leave it open).
//
// With q = -(b + sign(b) sqrt(D)), which adds numbers of one sign, the roots are c / q and q / a. If both are positive
// the first is the nearer one, for their product c / a is then positive, so that q² >= b² >= a c; no order of the roots
// need be decided. In double-double, the last stage, what is still open is a tie: a number within its error of zero is
// zero, and a touch is a hit.
template <class N, class T, class Within>
Decision nearest_root(const Quadratic<N> &quadratic, const Ray<T> &ray, const Within &within) {
    constexpr bool last = std::is_same_v<N, DoubleDouble>;
    constexpr Decision open{false}, miss{true};
    const auto &[a, b, c, discriminant, a_error, b_error, c_error, discriminant_error] = quadratic;

    const int real = sure_sign(discriminant, discriminant_error);
    if (real < 0)
        return miss;
    if (real == 0 && !last)
        return open;
    if (real == 0 && !(std::abs(static_cast<double>(discriminant)) <= discriminant_error))
        return miss; // NaN: numbers too large for a double
    const N root = real == 0 ? N(0.0) : square_root(discriminant);
    const N q = static_cast<double>(b) < 0 ? root - b : -(root + b);
    const double q_size = std::abs(static_cast<double>(q));
    if (!last && !(q_size * static_cast<double>(root) > clear_of_error * discriminant_error))
        return open;
    if (last && q_size <= b_error)
        return miss; // a double root at t = 0

    const bool forward = static_cast<double>(q) > 0;
    const int c_sign = sure_sign(c, c_error), a_sign = sure_sign(a, a_error);
    if (c_sign == 0 && !last)
        return open;
    if (c_sign != 0 && (c_sign > 0) == forward) {
        if (!last && !(std::abs(static_cast<double>(c)) > clear_of_error * c_error))
            return open;
        const N t = c / q;
        const int place = within(t);
        if (place == 0 && !last)
            return open;
        if (const T rounded = static_cast<T>(static_cast<double>(t)); place >= 0 && in_range(ray, rounded))
            return {true, static_cast<double>(rounded)};
    }
    if (a_sign == 0)
        return last ? miss : open;
    if ((a_sign > 0) != forward)
        return miss;
    if (!last && !(std::abs(static_cast<double>(a)) > clear_of_error * a_error))
        return open;
    const N t = q / a;
    const int place = within(t);
    if (place == 0 && !last)
        return open;
    if (const T rounded = static_cast<T>(static_cast<double>(t)); place >= 0 && in_range(ray, rounded))
        return {true, static_cast<double>(rounded)};
    return miss;
}

} // namespace course
