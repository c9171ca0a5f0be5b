// Lesson 02, step 9: the cylinder's default test, guarded as chapter 01's sphere is.
#pragma once
#include "chapters/01_ray_casting/guarded.hpp"

#include <algorithm>

namespace course {

template <class S> struct Cylinder;

// Whether the point at t lies between the ends: 0 <= m · n + t d · n <= n · n. 1 yes, -1 no, 0 too near to an end to
// tell, when t is off by t_error of itself and the dot products by rounding errors of their own.
template <class N> struct BetweenEnds {
    N mn, dn, nn;
    double mm, dd, t_error;

    int operator()(const N &t) const {
        const N rise = t * dn, height = mn + rise;
        const double moved = static_cast<double>(t);
        const double error = t_error * std::abs(static_cast<double>(rise)) +
                             16 * rounding_of<N> * (mm + static_cast<double>(nn) + moved * moved * dd);
        return std::min(sure_sign(height, error), sure_sign(N(nn - height), error));
    }
};

// For t as nearest_root() hands it on: within 2^-25 of itself, and in double-double far closer.
template <class N> BetweenEnds<N> between_ends(const Triple<N> &d, const Triple<N> &m, const Triple<N> &n) {
    constexpr double t_error = std::is_same_v<N, double> ? 0x1p-25 : 0x1p-80;
    return {dot(m, n), dot(d, n), dot(n, n), static_cast<double>(dot(m, m)), static_cast<double>(dot(d, d)), t_error};
}

// The same for a ray in double, whose roots one step of Newton's method brings to a few roundings of a double, as
// chapter 01 does for its sphere. The wall is nn (p · p - r²) = (p · n)² for the cylinder, nn² p · p = (nn + r²) (p ·
// n)² for the cone: both are x p · p - y (p · n)² = z.
struct PolishedBetweenEnds : BetweenEnds<double> {
    Triple<double> d, m;
    double x, y, z;

    double polished(double t) const {
        const Triple<double> p{m[0] + t * d[0], m[1] + t * d[1], m[2] + t * d[2]};
        const double pn = mn + t * dn;
        return t - (x * dot(p, p) - y * pn * pn - z) / (2 * (x * dot(p, d) - y * pn * dn));
    }
};

// The textbook's coefficients, times n · n. Of 25, 25 and 92 roundings, each bound leaves room for 32, 32 and 128.
inline Quadratic<double> textbook_quadratic(const BetweenEnds<double> &along, double dm, double r) {
    const auto &[mn, dn, nn, mm, dd, _] = along;
    const double a_size = nn * dd, c_size = nn * (mm + r * r);
    const double a = a_size - dn * dn, b = nn * dm - dn * mn, c = nn * (mm - r * r) - mn * mn;
    return {a, b, c, b * b - a * c, 0x1p-48 * a_size, 0, 0x1p-48 * c_size, 0x1p-46 * (a_size * c_size)};
}

// The same coefficients from cross products, whose errors shrink with the angle to the axis; run in double and, last,
// in double-double. The discriminant is n · n times r² |w|² - (m · w)² with w = d x n: the distance of ray and axis.
template <class N>
Quadratic<N> sharper_cylinder(const Triple<N> &d, const Triple<N> &m, const Triple<N> &n, double radius) {
    constexpr double u = rounding_of<N>;
    const Triple<N> w = cross(d, n), v = cross(m, n);
    const N nn = dot(n, n), rr = N(radius) * N(radius), mw = dot(m, w), ww = dot(w, w), vv = dot(v, v);
    const double w_size = size_of(w), v_size = size_of(v), m_size = size_of(m);
    const double w_error = 8 * u * size_of(d) * size_of(n), v_error = 8 * u * m_size * size_of(n);
    const double ww_error = w_error * (2 * w_size + w_error) + 8 * u * w_size * w_size;
    const double vv_error = v_error * (2 * v_size + v_error) + 8 * u * v_size * v_size;
    const double mw_error = m_size * (w_error + 8 * u * w_size), mw_size = std::abs(static_cast<double>(mw));
    const double scale = static_cast<double>(nn), r2 = radius * radius;
    return {ww,
            dot(w, v),
            vv - rr * nn,
            nn * (rr * ww - mw * mw),
            ww_error,
            w_error * v_size + w_size * v_error + w_error * v_error + 8 * u * w_size * v_size,
            vv_error + 16 * u * r2 * scale,
            scale * (r2 * ww_error + mw_error * (2 * mw_size + mw_error) +
                     16 * u * (r2 * w_size * w_size + mw_size * mw_size))};
}

template <class T, class S>
[[gnu::noinline, gnu::cold]] std::optional<T> intersect_in_doubt(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    const auto decide = [&]<class N>(N) {
        const auto d = triple<N>(ray.direction), bottom = triple<N>(cylinder.bottom);
        const auto n = triple<N>(cylinder.top) - bottom, m = triple<N>(ray.origin) - bottom;
        return nearest_root(sharper_cylinder(d, m, n, static_cast<double>(cylinder.radius)), ray,
                            between_ends(d, m, n));
    };
    const auto sharper = decide(double{});
    return sharper.sure ? sharper.t : decide(DoubleDouble{}).t;
}

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is.
template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    const auto d = triple<double>(ray.direction), bottom = triple<double>(cylinder.bottom);
    const auto n = triple<double>(cylinder.top) - bottom, m = triple<double>(ray.origin) - bottom;
    const double r = static_cast<double>(cylinder.radius);
    const auto along = between_ends(d, m, n);
    const auto quick = [&, quadratic = textbook_quadratic(along, dot(d, m), r)] {
        if constexpr (std::is_same_v<T, double>)
            return nearest_root(quadratic, ray, PolishedBetweenEnds{along, d, m, along.nn, 1, along.nn * r * r});
        else
            return nearest_root(quadratic, ray, along);
    }();
    return quick.sure ? quick.t : intersect_in_doubt(ray, cylinder);
}

} // namespace course
