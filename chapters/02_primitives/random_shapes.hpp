// Lesson 02, for its measurements and tests: shapes and rays drawn at random, about two units large, so that a fair
// share of the rays hits.
#pragma once
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/02_primitives/lattice_blob.hpp"
#include "chapters/02_primitives/torus.hpp"
#include "common/random.hpp"

namespace course {

inline Vec<double> random_vector(Random &random, double reach) {
    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
    return {x, y, random.uniform(-reach, reach)};
}
inline Vec<float> random_point(Random &random) { return Vec<float>(random_vector(random, 2)); }
inline float random_radius(Random &random) { return static_cast<float>(random.uniform(0.2, 2)); }

// A ray from within six units that points at the middle two, of any length.
inline Ray<double> random_ray(Random &random) {
    const Vec<double> origin = random_vector(random, 6), towards = random_vector(random, 1);
    return {origin, random.uniform(0.1, 2) * (towards - origin)};
}

// The second argument only says which shape is asked for. Arguments within braces are drawn from left to right.
inline Sphere<> random_shape(Random &r, const Sphere<> &) { return {random_point(r), random_radius(r)}; }
inline Plane<> random_shape(Random &r, const Plane<> &) { return {random_point(r), random_point(r)}; }
inline Disk<> random_shape(Random &r, const Disk<> &) { return {random_point(r), random_point(r), random_radius(r)}; }
inline AffineTriangle<> random_shape(Random &r, const AffineTriangle<> &) {
    const Vec<float> a = random_point(r), b = random_point(r);
    return affine_triangle(a, b, random_point(r));
}
inline Cylinder<> random_shape(Random &r, const Cylinder<> &) {
    return {random_point(r), random_point(r), random_radius(r)};
}
inline Cone<> random_shape(Random &r, const Cone<> &) { return {random_point(r), random_point(r), random_radius(r)}; }
inline Box<> random_shape(Random &r, const Box<> &) {
    const Vec<float> a = random_point(r), b = random_point(r);
    return {min(a, b), max(a, b)};
}
inline Implicit<Torus<>> random_shape(Random &r, const Implicit<Torus<>> &) {
    const float ring = static_cast<float>(r.uniform(0.5, 2)), share = static_cast<float>(r.uniform(0.1, 0.9));
    return shape_of(Torus<>{random_point(r), random_point(r), ring, ring * share});
}
inline Implicit<LatticeBlob<>> random_shape(Random &r, const Implicit<LatticeBlob<>> &) {
    return shape_of(LatticeBlob<>{random_point(r), random_radius(r), static_cast<float>(r.uniform(0.5, 3.5))});
}

// A torus a hundred times as wide as thick, around the place where the rays point.
struct ThinRing : Torus<> {};
inline Implicit<ThinRing> random_shape(Random &r, const Implicit<ThinRing> &) {
    const float ring = static_cast<float>(r.uniform(0.5, 1.5));
    const auto shape = shape_of(Torus<>{{0, 0, 0}, random_point(r), ring, 0.01f * ring});
    return {{shape.f}, shape.bounds};
}

} // namespace course
