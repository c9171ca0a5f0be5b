// Lesson 02, step 5b: the cylinder's default test, guarded as chapter 01's sphere is.
#pragma once
#include "chapters/01_ray_casting/guarded.hpp"

#include <algorithm>

namespace course {

template <class S> struct Cylinder;

// A wall around the axis n, by what a ray brings along: m is its origin seen from the wall's start.
struct BesideAxis {
    Vec<double> d, m, n;
    double d_size, m_size, n_size;

    template <class T, class S> BesideAxis(const Ray<T> &ray, const Vec<S> &start, const Vec<S> &end)
        : d(ray.direction), m(Vec<double>(ray.origin) - Vec<double>(start)), n(Vec<double>(end) - Vec<double>(start)),
          d_size(size_of(d)), m_size(size_of(m)), n_size(size_of(n)) {}
};

// Whether the point at t lies between the ends: 0 <= m · n + t d · n <= n · n. 1 yes, -1 no, 0 too near to an end to
// tell, when t is off by t_error of itself and the dot products by at most 16 roundings.
template <class N> struct BetweenEnds {
    N mn, dn, nn;
    double m_size, d_size, t_error; // at least |m| |n| and |d| |n|

    int operator()(const N &t) const {
        const N rise = t * dn, height = mn + rise;
        const double error = t_error * std::abs(static_cast<double>(rise)) +
                             16 * rounding_of<N> * (m_size + std::abs(static_cast<double>(t)) * d_size);
        return std::min(sure_sign(height, error), sure_sign(N(nn - height), error));
    }
};

// For t as nearest_root() hands it on: within 2^-25 of itself, and in double-double far closer.
template <class N> BetweenEnds<N> between_ends(const Triple<N> &d, const Triple<N> &m, const Triple<N> &n) {
    constexpr double t_error = std::is_same_v<N, double> ? 0x1p-25 : 0x1p-80;
    return {dot(m, n), dot(d, n), dot(n, n), size_of(m) * size_of(n), size_of(d) * size_of(n), t_error};
}

// The same in stage one. Where the ray's scalar is double, an accepted root is bettered by one step of Newton's method
// on x |p x n|² - y (p · n)² = z, to a few roundings of a double: the shadow ray to a lamp must end short of it by its
// rounding alone. The wall is |p x n|² = r² n · n for the cylinder, n · n |p x n|² = r² (p · n)² for the cone.
template <class T> struct OnWall : BetweenEnds<double> {
    Vec<double> mxn, dxn;
    double x, y, z;

    double polished(double t) const {
        if constexpr (sizeof(T) < sizeof(double))
            return t;
        const Vec<double> q = mxn + t * dxn;
        const double height = mn + t * dn;
        return t - (x * dot(q, q) - y * height * height - z) / (2 * (x * dot(q, dxn) - y * height * dn));
    }
};

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

// Stages two and three: sharper(d, m, n) makes the quadratic, in double and then in double-double.
template <class T, class S, class Sharper>
double wall_in_doubt(const Ray<T> &ray, const Vec<S> &start, const Vec<S> &end, const Sharper &sharper) {
    const auto decide = [&]<class N>(N) {
        const auto d = triple<N>(ray.direction), from = triple<N>(start);
        const auto n = triple<N>(end) - from, m = triple<N>(ray.origin) - from;
        return nearest_root(sharper(d, m, n), ray, between_ends(d, m, n));
    };
    const auto in_double = decide(double{});
    return in_double.sure ? in_double.t : decide(DoubleDouble{}).t;
}

template <class T, class S>
[[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    return wall_in_doubt(ray, cylinder.bottom, cylinder.top, [&](const auto &d, const auto &m, const auto &n) {
        return sharper_cylinder(d, m, n, static_cast<double>(cylinder.radius));
    });
}

// The nearest root in front of the ray and on the wall, or nowhere.
template <class T, class S> inline double nearest_t(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    const auto [d, m, n, d_size, m_size, n_size] = BesideAxis(ray, cylinder.bottom, cylinder.top);
    const double r = static_cast<double>(cylinder.radius), rr = r * r;
    const auto in_doubt = [&] { return t_in_doubt(ray, cylinder); };

    // How far the ray's line is from the axis.
    const Vec<double> w = cross(d, n);
    const double ww = dot(w, w), mw = dot(m, w), w_size = d_size * n_size, reach = m_size + r;
    const double discriminant = rr * ww - mw * mw;
    const double error = w_size * w_size * reach * (0x1p-48 * r + 0x1p-99 * reach);
    if (!(discriminant > error))
        return discriminant < -error ? nowhere : in_doubt();

    const Vec<double> v = cross(m, n);
    const double nn = dot(n, n);
    const OnWall<T> wall{{dot(m, n), dot(d, n), nn, m_size * n_size, w_size, 0x1p-25}, v, w, 1, 0, rr * nn};
    return nearest_of_two(ray, ww, dot(w, v), std::sqrt(nn * discriminant), 2 * clear_of_error * nn * error, wall,
                          in_doubt);
}

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is.
template <class T, class S> inline std::optional<T> intersect(const Ray<T> &ray, const Cylinder<S> &cylinder) {
    return hit_in_range(ray, nearest_t(ray, cylinder));
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template double t_in_doubt(const Ray<double> &, const Cylinder<float> &);
#endif

} // namespace course
