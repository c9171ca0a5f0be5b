// Lesson 02, step 10: the cone's default test, guarded; exact even where rays graze the apex.
#pragma once
#include "chapters/02_primitives/cylinder_guarded.hpp"

namespace course {

template <class S> struct Cone;

// The textbook's coefficients, times (n · n)², with k = n · n + r². Of 36, 40 and 250 roundings, each bound leaves room
// for 64, 64 and 256.
inline Quadratic<double> textbook_cone_quadratic(const BetweenEnds<double> &along, double dm, double r) {
    const auto &[mn, dn, nn, mm, dd, _] = along;
    const double k = nn + r * r, a_size = k * nn * dd, c_size = k * nn * mm;
    const double a = nn * (nn * dd) - k * (dn * dn), b = nn * (nn * dm) - k * (dn * mn);
    const double c = nn * (nn * mm) - k * (mn * mn);
    return {a, b, c, b * b - a * c, 0x1p-47 * a_size, 0, 0x1p-47 * c_size, 0x1p-45 * (a_size * c_size)};
}

// The same coefficients from cross products, run in double and, last, in double-double. The discriminant is (n · n)²
// times r² (n · n) |w|² - k (w · n)² with w = d x m, which stays as exact as the input where the ray passes the apex.
template <class N>
Quadratic<N> sharper_cone(const Triple<N> &d, const Triple<N> &m, const Triple<N> &n, double radius) {
    constexpr double u = rounding_of<N>;
    const Triple<N> dxn = cross(d, n), mxn = cross(m, n), w = cross(d, m);
    const N nn = dot(n, n), rr = N(radius) * N(radius), k = nn + rr, dn = dot(d, n), mn = dot(m, n), wn = dot(w, n);
    const N ww = dot(w, w);

    const double d_size = size_of(d), m_size = size_of(m), n_size = size_of(n), r2 = radius * radius;
    const double p = size_of(dxn), q = size_of(mxn), w_size = size_of(w);
    const double p_error = 8 * u * d_size * n_size, q_error = 8 * u * m_size * n_size,
                 w_error = 8 * u * d_size * m_size;
    const auto square_error = [](double size, double error) { return error * (2 * size + error); };
    const double dn_size = std::abs(static_cast<double>(dn)), mn_size = std::abs(static_cast<double>(mn));
    const double wn_size = std::abs(static_cast<double>(wn)), wn_error = n_size * (w_error + 8 * u * w_size);
    const double scale = static_cast<double>(nn), k_scale = scale + r2;
    return {nn * dot(dxn, dxn) - rr * dn * dn,
            nn * dot(dxn, mxn) - rr * dn * mn,
            nn * dot(mxn, mxn) - rr * mn * mn,
            nn * nn * (rr * nn * ww - k * wn * wn),
            scale * square_error(p, p_error) + r2 * square_error(dn_size, p_error) +
                16 * u * (scale * p * p + r2 * dn_size * dn_size),
            scale * (p_error * q + p * q_error + p_error * q_error) +
                r2 * (p_error * mn_size + q_error * dn_size + p_error * q_error) +
                16 * u * (scale * p * q + r2 * dn_size * mn_size),
            scale * square_error(q, q_error) + r2 * square_error(mn_size, q_error) +
                16 * u * (scale * q * q + r2 * mn_size * mn_size),
            scale * scale *
                (r2 * scale * square_error(w_size, w_error) + k_scale * square_error(wn_size, wn_error) +
                 24 * u * (r2 * scale * w_size * w_size + k_scale * wn_size * wn_size))};
}

template <class T, class S>
[[gnu::noinline, gnu::cold]] std::optional<T> intersect_in_doubt(const Ray<T> &ray, const Cone<S> &cone) {
    const auto decide = [&]<class N>(N) {
        const auto d = triple<N>(ray.direction), apex = triple<N>(cone.apex);
        const auto n = triple<N>(cone.base) - apex, m = triple<N>(ray.origin) - apex;
        return nearest_root(sharper_cone(d, m, n, static_cast<double>(cone.radius)), ray, between_ends(d, m, n));
    };
    const auto sharper = decide(double{});
    return sharper.sure ? sharper.t : decide(DoubleDouble{}).t;
}

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is. The mirrored cone
// goes with the heights below 0, before the nearest root is chosen.
template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Cone<S> &cone) {
    const auto d = triple<double>(ray.direction), apex = triple<double>(cone.apex);
    const auto n = triple<double>(cone.base) - apex, m = triple<double>(ray.origin) - apex;
    const double r = static_cast<double>(cone.radius);
    const auto along = between_ends(d, m, n);
    const auto quick = [&, quadratic = textbook_cone_quadratic(along, dot(d, m), r)] {
        if constexpr (std::is_same_v<T, double>)
            return nearest_root(quadratic, ray,
                                PolishedBetweenEnds{along, d, m, along.nn * along.nn, along.nn + r * r, 0});
        else
            return nearest_root(quadratic, ray, along);
    }();
    return quick.sure ? quick.t : intersect_in_doubt(ray, cone);
}

} // namespace course
