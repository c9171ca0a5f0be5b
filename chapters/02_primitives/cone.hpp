// Lesson 02, step 6: the side of a cone, without the mirrored cone that its equation also describes.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/02_primitives/cone_guarded.hpp"
#include "chapters/02_primitives/quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace course {

// The side alone, from the apex (which belongs to it) to the rim of the base circle (likewise): `base` is that
// circle's centre and `radius` its radius.
template <class S = float> struct Cone {
    Vec<S> apex, base;
    S radius;
};

// The cone by note A's parameters (A 3.1.9). The axis points from the apex to the base and may have any length; the
// half angle, in radians, lies between 0 and pi / 2; the slant length runs from the apex to the rim.
template <class S = float>
Cone<S> cone_along(const Vec<double> &apex, const Vec<double> &axis, double half_angle, double slant_length) {
    const Vec<double> base = apex + slant_length * std::cos(half_angle) * normalize(axis);
    return {Vec<S>(apex), Vec<S>(base), static_cast<S>(slant_length * std::sin(half_angle))};
}

// With the axis n and p = o + t d - apex, the cone and its mirror image satisfy |p x n|² = (r² / |n|²) (p · n)². The
// discriminant of that quadratic, b² - a c, equals r² |n|² |w|² - (|n|² + r²) (w · n)² with w = d x m: near the apex
// b² and a c agree in nearly all digits, while w stays as exact as the input.
template <class T, class S> std::optional<T> intersect_cross_product(const Ray<T> &ray, const Cone<S> &cone) {
    const Vec<double> d(ray.direction), apex(cone.apex);
    const Vec<double> n = Vec<double>(cone.base) - apex, m = Vec<double>(ray.origin) - apex, w = cross(d, m);
    const double r = static_cast<double>(cone.radius), nn = dot(n, n), wn = dot(w, n);
    const double discriminant = r * r * nn * dot(w, w) - (nn + r * r) * wn * wn;
    if (!(discriminant >= 0))
        return {};

    // p · n is the height: positive on the cone, negative on its mirror image, |n|² at the rim. A root of the mirror
    // image must go before the nearest is chosen, or it would hide the cone behind it.
    const Vec<double> dxn = cross(d, n), mxn = cross(m, n);
    const double dn = dot(d, n), mn = dot(m, n), slope = r * r / nn;
    const double a = dot(dxn, dxn) - slope * dn * dn;
    const double b = dot(dxn, mxn) - slope * dn * mn;
    const double c = dot(mxn, mxn) - slope * mn * mn;
    for (const double root : roots(a, b, c, discriminant)) {
        const double height = mn + root * dn;
        if (const T t = static_cast<T>(root); height >= 0 && height <= nn && in_range(ray, t))
            return t;
    }
    return {};
}

// A eq. 40-42 with the square that eq. 40 lacks and with the roots in ascending order, in the ray's scalar throughout.
template <class T, class S> std::optional<T> intersect_textbook(const Ray<T> &ray, const Cone<S> &cone) {
    const Vec<T> apex(cone.apex), axis = Vec<T>(cone.base) - apex, m = ray.origin - apex;
    const T height = length(axis), radius = static_cast<T>(cone.radius);
    const Vec<T> n = axis / height;
    const T cos_squared = height * height / (height * height + radius * radius);
    const T dn = dot(ray.direction, n);
    const Vec<T> j = dot(m, n) * n - cos_squared * m;
    const T a = dn * dn - cos_squared * dot(ray.direction, ray.direction), b = dot(j, ray.direction), c = dot(j, m);
    const T discriminant = b * b - a * c;
    if (!(discriminant >= 0))
        return {};
    const T root = std::copysign(std::sqrt(discriminant), a);
    for (const T t : {(-b - root) / a, (-b + root) / a}) {
        const T z = dot(m, n) + dn * t;
        if (z >= 0 && z <= height && in_range(ray, t))
            return t;
    }
    return {};
}

// The normal is perpendicular to the line from the apex through the point, and leans away from the base; at the apex,
// where a cone has none, it points away from the base. The point is moved onto that line, between apex and rim.
template <class T, class S> Surface<T, Cone<S>> surface(const Ray<T> &ray, T t, const Cone<S> &cone) {
    const Vec<T> apex(cone.apex), n = Vec<T>(cone.base) - apex, m = point_at(ray, t) - apex;
    const T radius = static_cast<T>(cone.radius), nn = dot(n, n);
    const Vec<T> aside = m - (dot(m, n) / nn) * n;
    if (!(dot(aside, aside) > 0))
        return {apex, -normalize(n), cone};
    const Vec<T> outward = normalize(aside), to_rim = n + radius * outward;
    const T share = std::clamp(dot(m, to_rim) / dot(to_rim, to_rim), T(0), T(1));
    return {apex + share * to_rim, normalize(nn * outward - radius * n), cone};
}

} // namespace course
