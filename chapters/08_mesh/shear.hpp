// Lesson 08, step 3: look along the ray. In a plane that the ray pierces at (0, 0), a triangle is three points, and the
// question is whether it holds (0, 0).
#pragma once
#include "chapters/01_ray_casting/ray.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// A vertex as the ray sees it: x and y in the plane, z along the axis that the ray follows most.
struct Seen {
    double x, y, z;
};

// What a ray brings along for every triangle; to be made once per ray. The axes depend on the ray alone, and what it
// makes of a vertex depends on the ray and that vertex alone: two triangles with a vertex in common see it at the same
// place, bit for bit. Whatever rounding does, it moves the corners of a mesh and opens no gap between its triangles.
class Shear {
  public:
    template <class T> explicit Shear(const Ray<T> &ray) : Shear(Vec<double>(ray.origin), Vec<double>(ray.direction)) {}

    // The vertex relative to the origin, sheared along the ray and scaled by the direction's largest component. Woop,
    // Benthin and Wald (2013) divide by that component; without the division nothing is rounded before the
    // subtraction, as long as the ray's numbers are floats: a product of two of them fits into a double.
    template <class S> Seen operator()(const Vec<S> &vertex) const {
        const double x = static_cast<double>(component(vertex, x_)) - origin_.x;
        const double y = static_cast<double>(component(vertex, y_)) - origin_.y;
        const double z = static_cast<double>(component(vertex, z_)) - origin_.z;
        return {x * direction_.z - direction_.x * z, y * direction_.z - direction_.y * z, z};
    }

    // The direction's component along z: what a distance along z is divided by to give t.
    double along() const { return direction_.z; }

    // What else it takes to do the same for many vertices at once: where x, y and z are among a vertex's coordinates,
    // and the ray in that order.
    Vec<int> axes() const { return {x_, y_, z_}; }
    const Vec<double> &origin() const { return origin_; }
    const Vec<double> &direction() const { return direction_; }

  private:
    Shear(const Vec<double> &origin, const Vec<double> &direction) {
        const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
        const int larger_of_xy = x > y ? 0 : 1; // in steps that need no branch, since any axis is as likely
        z_ = std::max(x, y) > z ? larger_of_xy : 2;
        x_ = (0x000201 >> 8 * z_) & 3;
        y_ = (0x000201 >> 8 * x_) & 3;
        origin_ = {component(origin, x_), component(origin, y_), component(origin, z_)};
        direction_ = {component(direction, x_), component(direction, y_), component(direction, z_)};
    }

    // v[i] without GLM's branches.
    template <class S> static S component(const Vec<S> &v, int i) { return (&v.x)[i]; }

    int x_, y_, z_;
    Vec<double> origin_, direction_; // permuted
};

// A ray that brings its shear along, for those who test it against many triangles. R may be any kind of ray.
template <class R> struct Sheared : R {
    Shear shear;

    explicit Sheared(const R &ray) : R(ray), shear(ray) {}
};

// The ray with its shear, made at most once.
template <class R> Sheared<R> with_shear(const R &ray) { return Sheared<R>(ray); }
template <class R> Sheared<R> with_shear(const Sheared<R> &ray) { return ray; }

} // namespace course
