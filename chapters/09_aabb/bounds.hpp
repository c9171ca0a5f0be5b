// Lesson 09, step 1: the smallest axis-aligned box around each shape, never a hair too small.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/08_mesh/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

namespace course {

// ---- Boxes as sets: the empty one, the box around two, their size
// ----------------------------------------------------

// Around nothing: merging it with a box gives that box.
template <class S = float> Box<S> empty_box() { return {Vec<S>(infinity<S>), Vec<S>(-infinity<S>)}; }

// Whether the box holds a point. False also for a box with a NaN.
template <class S> bool holds_any(const Box<S> &box) {
    return box.lo.x <= box.hi.x && box.lo.y <= box.hi.y && box.lo.z <= box.hi.z;
}

template <class S> Box<S> merge(const Box<S> &a, const Box<S> &b) { return {min(a.lo, b.lo), max(a.hi, b.hi)}; }

template <class S> Box<S> common_part(const Box<S> &a, const Box<S> &b) { return {max(a.lo, b.lo), min(a.hi, b.hi)}; }

// The edge lengths: zero for a flat box in its flat direction.
template <class S> Vec<double> extent(const Box<S> &box) { return Vec<double>(box.hi) - Vec<double>(box.lo); }

template <class S> Vec<double> centre(const Box<S> &box) {
    return 0.5 * Vec<double>(box.lo) + 0.5 * Vec<double>(box.hi);
}

template <class S> double surface_area(const Box<S> &box) {
    if (!holds_any(box))
        return 0;
    const Vec<double> e = extent(box);
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

// The largest coordinate without its sign: what rounding errors near the box are measured by.
template <class S> double largest_coordinate(const Box<S> &box) {
    const Vec<double> c = max(abs(Vec<double>(box.lo)), abs(Vec<double>(box.hi)));
    return std::max({c.x, c.y, c.z});
}

// ---- Rounding outwards ----------------------------------------------------------------------------------------------

// The largest S that is not above x, and the smallest that is not below. NaN stays NaN.
template <class S> S rounded_down(double x) {
    const S s = static_cast<S>(x);
    return static_cast<double>(s) > x ? std::nextafter(s, -infinity<S>) : s;
}
template <class S> S rounded_up(double x) { return -rounded_down<S>(-x); }

template <class S> Box<S> rounded_outward(const Vec<double> &lo, const Vec<double> &hi) {
    return {{rounded_down<S>(lo.x), rounded_down<S>(lo.y), rounded_down<S>(lo.z)},
            {rounded_up<S>(hi.x), rounded_up<S>(hi.y), rounded_up<S>(hi.z)}};
}
template <class S, class From> Box<S> rounded_outward(const Box<From> &box) {
    if constexpr (sizeof(S) >= sizeof(From))
        return {Vec<S>(box.lo), Vec<S>(box.hi)};
    else
        return rounded_outward<S>(Vec<double>(box.lo), Vec<double>(box.hi));
}

// ---- The box of every shape that has one ----------------------------------------------------------------------------
// In the scalar that the shape stores. What is not stored but computed, in double, is rounded outwards; the rounding of
// that computation itself (2^-53) is left to the slab test, whose margin is far wider.

template <class S> Box<S> bounds(const Box<S> &box) { return box; }

template <class S> Box<S> bounds(const Triangle<S> &triangle) {
    return {min(triangle.a, min(triangle.b, triangle.c)), max(triangle.a, max(triangle.b, triangle.c))};
}

template <class S> Box<S> bounds(const Sphere<S> &sphere) {
    const Vec<double> c(sphere.centre), r(static_cast<double>(sphere.radius));
    return rounded_outward<S>(c - r, c + r);
}

// How far a circle reaches from its centre along each axis: r sin of the angle between its normal n (of any length) and
// the axis. The sine is taken from the two other components: sqrt(1 - cos²) would lose the thickness of a nearly
// axis-aligned disk.
inline Vec<double> circle_reach(const Vec<double> &n, double radius) {
    const Vec<double> sines = sqrt(Vec<double>(n.y * n.y + n.z * n.z, n.z * n.z + n.x * n.x, n.x * n.x + n.y * n.y));
    return radius / length(n) * sines;
}

template <class S> Box<S> bounds(const Disk<S> &disk) {
    const Vec<double> c(disk.centre);
    const Vec<double> reach = circle_reach(Vec<double>(disk.normal), static_cast<double>(disk.radius));
    return rounded_outward<S>(c - reach, c + reach);
}

template <class S> Box<S> bounds(const Cylinder<S> &cylinder) {
    const Vec<double> a(cylinder.bottom), b(cylinder.top);
    const Vec<double> reach = circle_reach(b - a, static_cast<double>(cylinder.radius));
    return rounded_outward<S>(min(a, b) - reach, max(a, b) + reach);
}

template <class S> Box<S> bounds(const Cone<S> &cone) {
    const Vec<double> apex(cone.apex), base(cone.base);
    const Vec<double> reach = circle_reach(base - apex, static_cast<double>(cone.radius));
    return rounded_outward<S>(min(apex, base - reach), max(apex, base + reach));
}

// The corners are found back from k1 and k2 with an error of a few roundings, for which one more step goes outwards.
template <class S> Box<S> bounds(const AffineTriangle<S> &triangle) {
    const auto [a, b, c] = corners(triangle);
    const Vec<double> lo = min(a, min(b, c)), hi = max(a, max(b, c));
    const Vec<double> step = static_cast<double>(std::numeric_limits<S>::epsilon()) * max(abs(lo), abs(hi));
    return rounded_outward<S>(lo - step, hi + step);
}

template <class S> Box<S> bounds(const Mesh<S> &mesh) {
    Box<S> box = empty_box<S>();
    for (Id id = 0; id < size(mesh); ++id)
        box = merge(box, bounds(triangle(mesh, id)));
    return box;
}

// An object is where its shape is.
template <class Shape, class Material> auto bounds(const Object<Shape, Material> &object)
    -> decltype(bounds(object.shape)) {
    return bounds(object.shape);
}

// ---- Who has bounds -------------------------------------------------------------------------------------------------

// Shapes that reach to infinity are named here; every other shape must have an overload of bounds(). Whether a shape
// has one is never asked to find out, since the answer would depend on which headers were read before.
template <class Shape> inline constexpr bool is_bounded = true;
template <class S> inline constexpr bool is_bounded<Plane<S>> = false;
template <class Shape, class Material> inline constexpr bool is_bounded<Object<Shape, Material>> = is_bounded<Shape>;

template <class Shape>
concept Bounded = requires(const Shape &shape) {
    bounds(shape).lo;
};

template <Bounded Shape> using ScalarOfBounds =
    std::remove_cvref_t<decltype(bounds(std::declval<const Shape &>()).lo.x)>;

// The box around many shapes; those that hold nothing, or NaN, add nothing.
template <Bounded Shape> Box<ScalarOfBounds<Shape>> bounds(std::span<const Shape> shapes) {
    auto box = empty_box<ScalarOfBounds<Shape>>();
    for (const Shape &shape : shapes)
        if (const auto own = bounds(shape); holds_any(own))
            box = merge(box, own);
    return box;
}

} // namespace course
