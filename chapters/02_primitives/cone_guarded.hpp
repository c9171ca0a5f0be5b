// Lesson 02, step 6b: the cone's default test, guarded; exact even where rays graze the apex.
#pragma once
#include "chapters/02_primitives/cylinder_guarded.hpp"

namespace course {

template <class S> struct Cone;

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

template <class T, class S> [[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const Cone<S> &cone) {
    return wall_in_doubt(ray, cone.apex, cone.base, [&](const auto &d, const auto &m, const auto &n) {
        return sharper_cone(d, m, n, static_cast<double>(cone.radius));
    });
}

// The nearest root in front of the ray and on the wall, or nowhere. The mirrored cone
// goes with the heights below 0, before the nearest root is chosen.
template <class T, class S> inline double nearest_t(const Ray<T> &ray, const Cone<S> &cone) {
    const auto [d, m, n, d_size, m_size, n_size] = BesideAxis(ray, cone.apex, cone.base);
    const double r = static_cast<double>(cone.radius), rr = r * r, nn = dot(n, n);
    const auto in_doubt = [&] { return t_in_doubt(ray, cone); };

    // How far the ray's line passes the apex, and on which side of the cone's own lines.
    const Vec<double> w = cross(d, m);
    const double wn = dot(w, n), w_size = d_size * m_size, reach = r + n_size;
    const double discriminant = rr * nn * dot(w, w) - (nn + rr) * (wn * wn);
    const double error = nn * (w_size * w_size) * reach * (0x1p-47 * r + 0x1p-99 * reach);
    if (!(discriminant > error))
        return discriminant < -error ? nowhere : in_doubt();

    const Vec<double> dxn = cross(d, n), mxn = cross(m, n);
    const double dn = dot(d, n), mn = dot(m, n), dxn_size = d_size * n_size, a_size = reach * dxn_size;
    const double a = nn * dot(dxn, dxn) - rr * (dn * dn), b = nn * dot(dxn, mxn) - rr * (dn * mn);
    if (!(std::abs(a) > 0x1p-21 * (a_size * a_size)))
        return in_doubt();
    const OnWall<T> wall{{mn, dn, nn, m_size * n_size, dxn_size, 0x1p-25}, mxn, dxn, nn, rr, 0};
    return nearest_of_two(ray, std::abs(a), std::copysign(1.0, a) * b, nn * std::sqrt(discriminant),
                          4 * clear_of_error * nn * error * n_size * reach, wall, in_doubt);
}

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is.
template <class T, class S> inline std::optional<T> intersect(const Ray<T> &ray, const Cone<S> &cone) {
    return hit_in_range(ray, nearest_t(ray, cone));
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template double t_in_doubt(const Ray<double> &, const Cone<float> &);
#endif

} // namespace course
