// Lesson 02, step 3b: the default tests of plane, disk and affine triangle, guarded as chapter 01's sphere is.
#pragma once
#include "chapters/01_ray_casting/guarded.hpp"

#include <algorithm>

namespace course {

template <class S> struct Plane;
template <class S> struct Disk;
template <class S> struct AffineTriangle;

// Where a ray meets a plane: t = gap / along, with gap = n · (point - o) and along = n · d, each within its error.
template <class N> struct PlaneCrossing {
    N gap, along;
    double gap_error, along_error;

    // Both this many times larger than their errors.
    bool is_clear(double times) const {
        const bool gap_is_clear = std::abs(static_cast<double>(gap)) > times * gap_error;
        const bool along_is_clear = std::abs(static_cast<double>(along)) > times * along_error;
        return gap_is_clear & along_is_clear; // both at once: one branch
    }
};

template <class N> PlaneCrossing<N> crossing(const Triple<N> &normal, const Triple<N> &to_point, const Triple<N> &d) {
    const auto sum = [](const Triple<N> &a, const Triple<N> &b) { // |a_x b_x| + |a_y b_y| + |a_z b_z|
        return std::abs(static_cast<double>(a[0]) * static_cast<double>(b[0])) +
               std::abs(static_cast<double>(a[1]) * static_cast<double>(b[1])) +
               std::abs(static_cast<double>(a[2]) * static_cast<double>(b[2]));
    };
    constexpr double error = 8 * rounding_of<N>; // of 4 roundings in each sum of products
    return {dot(normal, to_point), dot(normal, d), error * sum(normal, to_point), error * sum(normal, d)};
}

// t with twice the digits; a gap or slope within its error of zero is zero, and then no t lies in a ray's interval.
inline double last_parameter(const PlaneCrossing<DoubleDouble> &crossing) {
    if (sure_sign(crossing.gap, crossing.gap_error) == 0 || sure_sign(crossing.along, crossing.along_error) == 0)
        return 0;
    return static_cast<double>(crossing.gap / crossing.along);
}

// ---- Plane ---------------------------------------------------------------------------------------------------------

template <class N, class T, class S>
PlaneCrossing<N> crossing(const Ray<T> &ray, const Vec<S> &point, const Vec<S> &normal) {
    return crossing(triple<N>(normal), triple<N>(point) - triple<N>(ray.origin), triple<N>(ray.direction));
}

// t by the last stage, or 0, which lies in no ray's interval.
template <class T, class S> [[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const Plane<S> &plane) {
    return last_parameter(crossing<DoubleDouble>(ray, plane.point, plane.normal));
}

// A plane with the numbers that its test needs, for a loop over many rays: faster, and three times as large. The plane
// itself must outlive it. Of 4 roundings, each sum of products is off by at most 4 u times the sizes of its vectors;
// 8 u is asked for, and for t that each is clear of it.
template <class S> struct PreparedPlane {
    const Plane<S> *plane;
    Vec<double> point, normal;
    double least, least_gap; // for a ray of size one, and for the plane's own point

    explicit PreparedPlane(const Plane<S> &p)
        : plane(&p), point(p.point), normal(p.normal),
          least(8 * rounding_of<double> * clear_of_error * size_of(normal)), least_gap(least * size_of(point)) {}
};

// Exact hit or miss; t within an ulp of a float. Computed in double whatever the ray's scalar is.
template <class T, class S>
[[gnu::always_inline]] inline std::optional<T> intersect(const Ray<T> &ray, const PreparedPlane<S> &plane) {
    const Vec<double> o(ray.origin), d(ray.direction);
    const double gap = dot(plane.normal, plane.point - o), along = dot(plane.normal, d);
    const bool gap_is_clear = std::abs(gap) > plane.least_gap + plane.least * size_of(o);
    const bool along_is_clear = std::abs(along) > plane.least * size_of(d);
    const bool clear = gap_is_clear & along_is_clear; // both at once: one branch
    return hit_in_range(ray, clear ? gap / along : t_in_doubt(ray, *plane.plane));
}

template <class T, class S>
[[gnu::always_inline]] inline std::optional<T> intersect(const Ray<T> &ray, const Plane<S> &plane) {
    return intersect(ray, PreparedPlane<S>(plane));
}

// ---- Disk ----------------------------------------------------------------------------------------------------------

// The hit seen from the centre, times `along`, needs no division: gap d - along (centre - o).
template <class T, class S> [[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const Disk<S> &disk) {
    using N = DoubleDouble;
    const auto met = crossing<N>(ray, disk.centre, disk.normal);
    const auto d = triple<N>(ray.direction), f = triple<N>(disk.centre) - triple<N>(ray.origin);
    const Triple<N> p{met.gap * d[0] - met.along * f[0], met.gap * d[1] - met.along * f[1],
                      met.gap * d[2] - met.along * f[2]};
    const N reach = met.along * N(static_cast<double>(disk.radius)), beyond = dot(p, p) - reach * reach;
    const double part = static_cast<double>(met.along) * size_of(f);
    const double error = 0x1p-90 * (static_cast<double>(reach * reach) + part * part);
    return static_cast<double>(beyond) <= error ? last_parameter(met) : nowhere; // accepts, so that a NaN is no hit
}

// With t within 2^-30 of itself, the squared distance from the centre is within 2^-27 of (|f|² + r²) at the rim.
template <class T, class S> inline double nearest_t(const Ray<T> &ray, const Disk<S> &disk) {
    const auto d = triple<double>(ray.direction), f = triple<double>(disk.centre) - triple<double>(ray.origin);
    const auto met = crossing(triple<double>(disk.normal), f, d);
    if (!met.is_clear(16 * clear_of_error))
        return t_in_doubt(ray, disk);
    const double t = met.gap / met.along, r = static_cast<double>(disk.radius);
    const Triple<double> p{t * d[0] - f[0], t * d[1] - f[1], t * d[2] - f[2]};
    const double beyond = dot(p, p) - r * r, error = 0x1p-27 * (dot(f, f) + r * r);
    if (beyond > error)
        return nowhere;
    return beyond < -error ? t : t_in_doubt(ray, disk);
}

template <class T, class S> inline std::optional<T> intersect(const Ray<T> &ray, const Disk<S> &disk) {
    return hit_in_range(ray, nearest_t(ray, disk));
}

// ---- Affine triangle -----------------------------------------------------------------------------------------------

// The coordinates of the hit times `along`: k · ((o - corner) along + gap d).
template <class T, class S>
[[gnu::noinline, gnu::cold]] double t_in_doubt(const Ray<T> &ray, const AffineTriangle<S> &triangle) {
    using N = DoubleDouble;
    const auto met = crossing<N>(ray, triangle.corner, triangle.normal);
    const auto d = triple<N>(ray.direction), m = triple<N>(ray.origin) - triple<N>(triangle.corner);
    const auto k1 = triple<N>(triangle.k1), k2 = triple<N>(triangle.k2);
    const int side = static_cast<double>(met.along) > 0 ? 1 : -1;
    const N u = dot(k1, m) * met.along + dot(k1, d) * met.gap, v = dot(k2, m) * met.along + dot(k2, d) * met.gap;
    const double reach =
        std::abs(static_cast<double>(met.along)) * size_of(m) + std::abs(static_cast<double>(met.gap)) * size_of(d);
    const double u_error = 0x1p-90 * size_of(k1) * reach, v_error = 0x1p-90 * size_of(k2) * reach;
    // These comparisons accept, so that a NaN is no hit.
    const bool inside = side * static_cast<double>(u) >= -u_error && side * static_cast<double>(v) >= -v_error &&
                        side * static_cast<double>(met.along - u - v) >= -(u_error + v_error);
    return inside ? last_parameter(met) : nowhere;
}

template <class T, class S> inline double nearest_t(const Ray<T> &ray, const AffineTriangle<S> &triangle) {
    const auto d = triple<double>(ray.direction), f = triple<double>(triangle.corner) - triple<double>(ray.origin);
    const auto met = crossing(triple<double>(triangle.normal), f, d);
    if (!met.is_clear(16 * clear_of_error))
        return t_in_doubt(ray, triangle);
    const double t = met.gap / met.along;
    const Triple<double> p{t * d[0] - f[0], t * d[1] - f[1], t * d[2] - f[2]};
    const auto k1 = triple<double>(triangle.k1), k2 = triple<double>(triangle.k2);
    const double u = dot(k1, p), v = dot(k2, p), reach = 0x1p-28 * (size_of(f) + std::abs(t) * size_of(d));
    const double u_error = reach * size_of(k1), v_error = reach * size_of(k2), w_error = u_error + v_error;
    if (u < -u_error || v < -v_error || 1 - u - v < -w_error)
        return nowhere;
    const bool inside = u > u_error && v > v_error && 1 - u - v > w_error;
    return inside ? t : t_in_doubt(ray, triangle);
}

template <class T, class S> inline std::optional<T> intersect(const Ray<T> &ray, const AffineTriangle<S> &triangle) {
    return hit_in_range(ray, nearest_t(ray, triangle));
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template double t_in_doubt(const Ray<double> &, const Plane<float> &);
extern template double t_in_doubt(const Ray<double> &, const Disk<float> &);
extern template double t_in_doubt(const Ray<double> &, const AffineTriangle<float> &);
#endif

} // namespace course
