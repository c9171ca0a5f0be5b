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
    template <class T> [[gnu::always_inline]] explicit Shear(const Ray<T> &ray) {
        const double x = std::abs(static_cast<double>(ray.direction.x)),
                     y = std::abs(static_cast<double>(ray.direction.y));
        const double z = std::abs(static_cast<double>(ray.direction.z));
        const int larger_of_xy = x > y ? 0 : 1, is_z = !(std::max(x, y) > z); // without a branch: any axis is as likely
        z_ = larger_of_xy + is_z * (2 - larger_of_xy);
        x_ = (0x000201 >> 8 * z_) & 3;
        y_ = (0x000201 >> 8 * x_) & 3;
        origin_ = {component(ray.origin, x_), component(ray.origin, y_), component(ray.origin, z_)};
        direction_ = {component(ray.direction, x_), component(ray.direction, y_), component(ray.direction, z_)};
    }

    // The vertex relative to the origin, sheared along the ray and scaled by the direction's largest component. Woop,
    // Benthin and Wald (2013) divide by that component; without the division nothing is rounded before the
    // subtraction, as long as the ray's numbers are floats: a product of two of them fits into a double.
    template <class S> Seen operator()(const Vec<S> &vertex) const {
        return in_order(component(vertex, x_), component(vertex, y_), component(vertex, z_));
    }
    // The same for a vertex whose coordinates are already in the order of axes().
    Seen in_order(double vertex_x, double vertex_y, double vertex_z) const {
        const double x = vertex_x - origin_.x, y = vertex_y - origin_.y, z = vertex_z - origin_.z;
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
    // v[i] without GLM's branches.
    template <class S> static double component(const Vec<S> &v, int i) { return static_cast<double>((&v.x)[i]); }

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
