// Lesson 08, step 4: the mesh triangle and its watertight test, which no ray slips past at an edge or a corner.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "chapters/08_mesh/shear.hpp"

#include <algorithm>
#include <cmath>
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
// and c changes the sign and nothing else. The sign is exact: rounding never turns the order of two products around,
// so two that differ as rounded differ so in truth; where they agree, the parts that were rounded off decide.
inline double edge_function(const Seen &b, const Seen &c) {
    const double p = c.x * b.y, q = c.y * b.x;
    return p != q ? p - q : difference_of_products(c.x, b.y, c.y, b.x);
}

// An edge function of 0 says that the ray passes exactly through the edge's line. It then takes the sign that it would
// have if the ray passed a hair to the right (dx), and a hair of that hair above (dx²): 0 only for an edge that is
// seen as a point.
inline double settled(double edge, const Seen &b, const Seen &c) {
    return edge != 0 ? edge : c.y != b.y ? c.y - b.y : b.x - c.x;
}

// (b - a) x (c - a) in double: the normal, twice as long as the area is large. Right to the last bits also for a
// needle; zero exactly when the corners lie on one line (but for coordinates 2^29 times apart, and underflow).
template <class S> Vec<double> area_vector(const Triangle<S> &triangle) {
    const Vec<double> a(triangle.a), p = Vec<double>(triangle.b) - a, q = Vec<double>(triangle.c) - a;
    return {difference_of_products(p.y, q.z, p.z, q.y), difference_of_products(p.z, q.x, p.x, q.z),
            difference_of_products(p.x, q.y, p.y, q.x)};
}

// The watertight test after Woop, Benthin and Wald (2013), in double inside whatever the ray's scalar is, with exact
// signs and a rule for ties: of the triangles around an edge or a corner of a closed mesh that the ray meets, it hits
// as many as if it had passed a hair beside. Both sides count. A triangle without area is never hit.
template <class T, class S>
std::optional<T> watertight(const Ray<T> &ray, const Shear &shear, const Triangle<S> &triangle) {
    const Seen a = shear(triangle.a), b = shear(triangle.b), c = shear(triangle.c);
    const double u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0)
        return {};

    // Only a ray that passes inside, or exactly through an edge's line, is still here. The comparisons let no NaN in.
    const double su = settled(u, b, c), sv = settled(v, c, a), sw = settled(w, a, b);
    if (!((su > 0 && sv > 0 && sw > 0) || (su < 0 && sv < 0 && sw < 0)))
        return {};

    // The hit is the mean of the corners with the weights u, v, w, so it cannot leave the triangle.
    const T t = static_cast<T>((u * a.z + v * b.z + w * c.z) / ((u + v + w) * shear.along()));
    if (!in_range(ray, t) || area_vector(triangle) == Vec<double>(0))
        return {};
    return t;
}

template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Triangle<S> &triangle) {
    return watertight(ray, Shear(ray), triangle);
}

// The same for a ray that has brought its shear along.
template <class R, class S>
std::optional<typename R::Scalar> intersect(const Sheared<R> &ray, const Triangle<S> &triangle) {
    return watertight(ray, ray.shear, triangle);
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
