// Lesson 08, step 4: the mesh triangle and its watertight test, which no ray slips past at an edge or a corner.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "chapters/08_mesh/shear.hpp"
#include "chapters/08_mesh/triangle_guarded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace course {

// S is the scalar that is stored. The corners run counter-clockwise as seen from outside.
template <class S = float> struct Triangle { Vec<S> a, b, c; };

// a b - c d, right to the last bit or two however much cancels (Kahan). Its sign is exact.
inline double difference_of_products(double a, double b, double c, double d) {
    const double p = a * b, q = c * d;
    return (p - q) + (std::fma(a, b, -p) - std::fma(c, d, -q));
}

// Twice the signed area of the triangle (0, 0), c, b: on which side of the edge from b to c the ray passes. Swapping b
// and c changes the sign and nothing else. The sign is exact wherever the result is not 0: rounding never turns the
// order of two products around, so where they differ as rounded they differ so in truth.
inline double edge_function(const Seen &b, const Seen &c) { return c.x * b.y - c.y * b.x; }

// The edge function where the two products came out equal: the parts that were rounded off decide.
inline double edge_function_in_doubt(const Seen &b, const Seen &c) {
    return difference_of_products(c.x, b.y, c.y, b.x);
}

// An edge function of 0 says that the ray passes exactly through the edge's line. It then takes the sign that it would
// have if the ray passed a hair to the right (dx), and a hair of that hair above (dx²): 0 only for an edge that is
// seen as a point.
inline double settled(double edge, const Seen &b, const Seen &c) {
    return edge != 0 ? edge : c.y != b.y ? c.y - b.y : b.x - c.x;
}

// Whether all three have the same sign, and none is 0 or NaN.
inline bool same_sign(double u, double v, double w) { return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0); }

// The hit is the mean of the corners with the weights u, v, w, so it cannot leave the triangle.
inline double weighted_t(const Seen &a, const Seen &b, const Seen &c, double u, double v, double w, double along) {
    return (u * a.z + v * b.z + w * c.z) / ((u + v + w) * along);
}

inline constexpr double no_hit = std::numeric_limits<double>::quiet_NaN();

// The rare case, kept out of the loops: at least one edge function came out as 0 (or NaN).
[[gnu::noinline]] inline double watertight_at_edges(const Seen &a, const Seen &b, const Seen &c, double along) {
    const double u = edge_function_in_doubt(b, c), v = edge_function_in_doubt(c, a), w = edge_function_in_doubt(a, b);
    return same_sign(settled(u, b, c), settled(v, c, a), settled(w, a, b)) ? weighted_t(a, b, c, u, v, w, along)
                                                                           : no_hit;
}

// The watertight test after Woop, Benthin and Wald (2013), in double, with exact signs and a rule for ties: of the
// triangles around an edge or a corner of a closed mesh that the ray meets, it hits as many as if it had passed a hair
// beside. Both sides count. Returns t, or NaN.
template <class S> inline double watertight(const Shear &shear, const Triangle<S> &triangle) {
    const Seen a = shear(triangle.a), b = shear(triangle.b), c = shear(triangle.c);
    const double u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    const double low = std::min({u, v, w}), high = std::max({u, v, w});
    if (low < 0 && high > 0)
        return no_hit;
    if (low > 0 || high < 0) // a NaN that slips through here makes t NaN
        return weighted_t(a, b, c, u, v, w, shear.along());
    return watertight_at_edges(a, b, c, shear.along());
}

// (b - a) x (c - a) in double: the normal, twice as long as the area is large. Right to the last bits also for a
// needle; zero exactly when the corners lie on one line (but for coordinates 2^29 times apart, and underflow).
template <class S> Vec<double> area_vector(const Triangle<S> &triangle) {
    const Vec<double> a(triangle.a), p = Vec<double>(triangle.b) - a, q = Vec<double>(triangle.c) - a;
    return {difference_of_products(p.y, q.z, p.z, q.y), difference_of_products(p.z, q.x, p.x, q.z),
            difference_of_products(p.x, q.y, p.y, q.x)};
}

template <class S> [[gnu::noinline]] bool has_no_area(const Triangle<S> &triangle) {
    return area_vector(triangle) == Vec<double>(0);
}

// The default. In double inside whatever the ray's scalar is. A triangle without area is never hit, though rounding may
// show it to the ray with a little. The t of a hit is within an ulp of a float.
template <class T, class S>
inline std::optional<T> intersect(const Ray<T> &ray, const Shear &shear, const Triangle<S> &triangle) {
    const double seen_t = watertight(shear, triangle);
    // Only the confirmed t may be held against t_max: a search narrows t_max, and what it returns must not depend on
    // the order in which it finds things.
    if (!(static_cast<T>(seen_t) > ray.t_min))
        return {};
    const T t = static_cast<T>(confirmed_t(ray, triangle, area_vector(triangle), seen_t));
    if (!in_range(ray, t))
        return {};
    return t;
}

template <class T, class S> inline std::optional<T> intersect(const Ray<T> &ray, const Triangle<S> &triangle) {
    return intersect(ray, Shear(ray), triangle);
}

// The same for a ray that has brought its shear along.
template <class R, class S>
inline std::optional<typename R::Scalar> intersect(const Sheared<R> &ray, const Triangle<S> &triangle) {
    return intersect(ray, ray.shear, triangle);
}

// The point is the hit moved along the normal onto the triangle's plane.
template <class T, class S> Surface<T, Triangle<S>> surface(const Ray<T> &ray, T t, const Triangle<S> &triangle) {
    const Vec<double> normal = normalize(area_vector(triangle)), point(point_at(ray, t));
    const double off = dot(normal, point - Vec<double>(triangle.a));
    return {Vec<T>(point - off * normal), Vec<T>(normal), triangle};
}

template <class S> double spawn_offset(const Triangle<S> &triangle, const Vec<double> &point) {
    const Vec<double> a(triangle.a);
    return rounding_bound(point, a, norm_1(Vec<double>(triangle.b) - a) + norm_1(Vec<double>(triangle.c) - a));
}

} // namespace course
