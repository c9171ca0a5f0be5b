// Lesson 01, step 8: the sphere's default test: the textbook's quadratic in double, guarded. It answers as exact
// arithmetic would, at nearly the textbook's cost, because almost no ray is in doubt.
#pragma once
#include "chapters/01_ray_casting/guarded.hpp"

namespace course {

template <class S> struct Sphere;

// The textbook's coefficients. With u = 2^-53 and f = o - centre: |f|² and r² are sums of products, so c is off by less
// than 8 u (|f|² + r²), and b² - a c by less than 32 u |d|² (|f|² + r²); the README of tests/hard_cases counts the
// roundings.
inline Quadratic<double> textbook_quadratic(const Vec<double> &d, const Vec<double> &f, double r) {
    const double a = dot(d, d), b = dot(d, f), ff = dot(f, f), rr = r * r;
    const double c = ff - rr, size = ff + rr;
    return {a, b, c, b * b - a * c, 0, 0, 0x1p-50 * size, 0x1p-48 * (a * size)};
}

// Every root of a sphere counts. One step of Newton's method on |f + t d|² = r² brings t, which the textbook's form may
// leave off by 2^-26 of itself, to a few roundings of a double: the shadow ray to a lamp must end short of it by its
// rounding alone. Only for roots that stage one is sure of: next to t = 0 the step would cost digits.
struct SphereRoots {
    Vec<double> d, f;
    double r;

    int operator()(double) const { return 1; }
    double polished(double t) const {
        const Vec<double> p = f + t * d;
        return t - (dot(p, p) - r * r) / (2 * dot(p, d));
    }
};

// The discriminant by the cross product, r² |d|² - |d x f|², whose error does not grow with the distance squared but
// with the distance alone; and c with twice the digits, for a ray that starts on the sphere or a hair beside it.
inline Quadratic<double> sharper_quadratic(const Triple<double> &d, const Triple<DoubleDouble> &offset, double r) {
    const Triple<double> f{offset[0].high, offset[1].high, offset[2].high}, w = cross(d, f);
    const double a = dot(d, d), b = dot(d, f), rr = r * r;
    const DoubleDouble c = dot(offset, offset) - two_product(r, r);
    const double w_size = size_of(w), w_error = 0x1p-50 * (size_of(d) * size_of(f));
    return {a,
            b,
            static_cast<double>(c),
            rr * a - dot(w, w),
            0,
            0,
            0x1p-52 * std::abs(c.high) + 0x1p-98 * (dot(f, f) + rr),
            0x1p-50 * (rr * a + w_size * w_size) + w_error * (2 * w_size + w_error)};
}

// The same in double-double.
inline Quadratic<DoubleDouble> sharpest_quadratic(const Triple<DoubleDouble> &d, const Triple<DoubleDouble> &f,
                                                  double r) {
    const Triple<DoubleDouble> w = cross(d, f);
    const DoubleDouble a = dot(d, d), b = dot(d, f), ff = dot(f, f), rr = two_product(r, r);
    const double sizes = size_of(d) * size_of(f), w_size = size_of(w), w_error = 0x1p-98 * sizes;
    const double scale = static_cast<double>(rr * a);
    return {a,
            b,
            ff - rr,
            rr * a - dot(w, w),
            0,
            0x1p-98 * sizes,
            0x1p-98 * static_cast<double>(ff + rr),
            0x1p-98 * (scale + w_size * w_size) + w_error * (2 * w_size + w_error)};
}

template <class T, class S>
[[gnu::noinline, gnu::cold]] std::optional<T> intersect_in_doubt(const Ray<T> &ray, const Sphere<S> &sphere) {
    const auto everywhere = [](const auto &) { return 1; };
    const auto d = triple<DoubleDouble>(ray.direction);
    const auto f = triple<DoubleDouble>(ray.origin) - triple<DoubleDouble>(sphere.centre);
    const double r = static_cast<double>(sphere.radius);
    const auto sharper = nearest_root(sharper_quadratic(triple<double>(ray.direction), f, r), ray, everywhere);
    return sharper.sure ? sharper.t : nearest_root(sharpest_quadratic(d, f, r), ray, everywhere).t;
}

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is.
template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Sphere<S> &sphere) {
    const Vec<double> d(ray.direction), f = Vec<double>(ray.origin) - Vec<double>(sphere.centre);
    const double r = static_cast<double>(sphere.radius);
    const auto quick = [&, quadratic = textbook_quadratic(d, f, r)] {
        if constexpr (std::is_same_v<T, double>)
            return nearest_root(quadratic, ray, SphereRoots{d, f, r});
        else
            return nearest_root(quadratic, ray, [](double) { return 1; });
    }();
    return quick.sure ? quick.t : intersect_in_doubt(ray, sphere);
}

} // namespace course
