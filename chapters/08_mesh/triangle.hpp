// Lesson 08, step 4: the mesh triangle and its watertight test, which no ray slips past at an edge or a corner.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"
#include "chapters/08_mesh/shear.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace course {

// S is the scalar that is stored. The corners run counter-clockwise as seen from outside.
template <class S = float> struct Triangle { Vec<S> a, b, c; };

// Twice the signed area of the triangle (0, 0), c, b: on which side of the edge from b to c the ray passes. Swapping b
// and c changes the sign and nothing else. The sign is exact: rounding never turns the order of two products around,
// so two that differ as rounded differ so in truth; where they agree, std::fma tells what their rounding cut off.
inline double edge_function(const Seen &b, const Seen &c) {
    const double p = c.x * b.y, q = c.y * b.x;
    return p != q ? p - q : std::fma(c.x, b.y, -p) - std::fma(c.y, b.x, -q);
}

// An edge function of 0 says that the ray passes exactly through the edge's line. It then takes the sign that it would
// have if the ray passed a hair to the right (dx), and a hair of that hair above (dx²): 0 only for an edge that is
// seen as a point.
inline double settled(double edge, const Seen &b, const Seen &c) {
    return edge != 0 ? edge : c.y != b.y ? c.y - b.y : b.x - c.x;
}

// Whether the three corners lie on one line, exactly (but for coordinates 2^29 times apart, and underflow).
template <class S> bool has_no_area(const Triangle<S> &triangle) {
    const Vec<double> e1 = Vec<double>(triangle.b) - Vec<double>(triangle.a);
    const Vec<double> e2 = Vec<double>(triangle.c) - Vec<double>(triangle.a);
    const auto parallel = [](double x1, double y1, double x2, double y2) {
        return edge_function({x1, y1, 0}, {x2, y2, 0}) == 0;
    };
    return parallel(e1.x, e1.y, e2.x, e2.y) && parallel(e1.y, e1.z, e2.y, e2.z) && parallel(e1.z, e1.x, e2.z, e2.x);
}

// The watertight test after Woop, Benthin and Wald (2013), in double inside whatever the ray's scalar is, with exact
// signs and a rule for ties: of the triangles around an edge or a corner of a closed mesh that the ray meets, it hits
// as many as if it had passed a hair beside. Both sides count. A triangle without area is never hit. `shear` is the
// ray's own, made once for many triangles.
template <class T, class S>
std::optional<T> intersect(const Ray<T> &ray, const Shear &shear, const Triangle<S> &triangle) {
    const Seen a = shear(triangle.a), b = shear(triangle.b), c = shear(triangle.c);
    const double u = edge_function(b, c), v = edge_function(c, a), w = edge_function(a, b);
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0)
        return {};

    // Only a ray that passes inside or exactly through an edge's line is still here. The positive test lets no NaN in.
    const double su = settled(u, b, c), sv = settled(v, c, a), sw = settled(w, a, b);
    if (!((su > 0 && sv > 0 && sw > 0) || (su < 0 && sv < 0 && sw < 0)))
        return {};

    // The hit is the mean of the corners with the weights u, v, w, so it cannot leave the triangle.
    const T t = static_cast<T>((u * a.z + v * b.z + w * c.z) / ((u + v + w) * shear.along()));
    if (!in_range(ray, t) || has_no_area(triangle))
        return {};
    return t;
}

template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const Triangle<S> &triangle) {
    return intersect(ray, Shear(ray), triangle);
}

// The normal of a triangle in double, of length one; NaN for a triangle without area.
template <class S> Vec<double> unit_normal(const Triangle<S> &triangle) {
    const Vec<double> a(triangle.a);
    return normalize(cross(Vec<double>(triangle.b) - a, Vec<double>(triangle.c) - a));
}

// The point is the hit moved along the normal onto the triangle's plane.
template <class T, class S> Surface<T, Triangle<S>> surface(const Ray<T> &ray, T t, const Triangle<S> &triangle) {
    const Vec<double> normal = unit_normal(triangle), point(point_at(ray, t));
    const double off = dot(normal, point - Vec<double>(triangle.a));
    return {Vec<T>(point - off * normal), Vec<T>(normal), triangle};
}

} // namespace course
