// Lesson 01, step 8: the sphere's default test: the textbook's quadratic in double, guarded. It answers as exact
// arithmetic would, at nearly the textbook's cost, because almost no ray is in doubt.
#pragma once
#include "chapters/01_ray_casting/guarded.hpp"

namespace course {

template <class S> struct Sphere;

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

template <class T, class S> [[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const Sphere<S> &sphere) {
    const auto everywhere = [](const auto &) { return 1; };
    const auto d = triple<DoubleDouble>(ray.direction);
    const auto f = triple<DoubleDouble>(ray.origin) - triple<DoubleDouble>(sphere.centre);
    const double r = static_cast<double>(sphere.radius);
    const auto sharper = nearest_root(sharper_quadratic(triple<double>(ray.direction), f, r), ray, everywhere);
    return sharper.sure ? sharper.t : nearest_root(sharpest_quadratic(d, f, r), ray, everywhere).t;
}

// Every root of a sphere counts, and is as good as it can be.
struct Anywhere {
    constexpr int operator()(double) const { return 1; }
    static constexpr double polished(double t) { return t; }
};

// The nearest root in front of the ray, or nowhere.
template <class T, class S> [[gnu::always_inline]] inline double nearest_t(const Ray<T> &ray, const Sphere<S> &sphere) {
    const Vec<double> d(ray.direction), f = Vec<double>(ray.origin) - Vec<double>(sphere.centre);
    const double r = static_cast<double>(sphere.radius), rr = r * r;

    // The textbook's discriminant b² - a c, and the least that a c can be: most rays end here, as sure misses.
    const double a = dot(d, d), b = dot(d, f);
    if (b * b < a * ((1 - 0x1p-48) * dot(f, f) - (1 + 0x1p-48) * rr))
        return nowhere;

    // The others are seen more sharply, by the cross product.
    const Vec<double> w = cross(d, f);
    const double reach = size_of(f) + r, error = a * reach * (0x1p-49 * r + 0x1p-100 * reach);
    const double discriminant = rr * a - dot(w, w);
    const auto in_doubt = [&] { return t_in_doubt(ray, sphere); };
    if (!(discriminant > error))
        return discriminant < -error ? nowhere : in_doubt();
    return nearest_of_two(ray, a, b, std::sqrt(discriminant), 2 * clear_of_error * error, Anywhere{}, in_doubt);
}

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is.
template <class T, class S>
[[gnu::always_inline]] inline std::optional<T> intersect(const Ray<T> &ray, const Sphere<S> &sphere) {
    return hit_in_range(ray, nearest_t(ray, sphere));
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template double t_in_doubt(const Ray<double> &, const Sphere<float> &);
#endif

} // namespace course
