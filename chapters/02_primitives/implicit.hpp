// Lesson 02, step 11: any surface f(x, y, z) = 0.
#pragma once
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/root_isolation.hpp"

#include <type_traits>

namespace course {

// The part of the surface f = 0 that lies within the box; f is negative inside and positive outside. F is a function
// object with the one template N operator()(const N &x, const N &y, const N &z) const, written with +, -, * and
// square(); the solver evaluates it in Interval and Dual numbers.
template <class F, class S = float> struct Implicit {
    F f;
    Box<S> bounds;
};

// Neither the stretch that is searched nor the root that ends the search, the first after t_min, depends on t_max: the
// t of a hit must not depend on what was hit before.
template <class T, class F, class S> std::optional<T> intersect(const Ray<T> &ray, const Implicit<F, S> &shape) {
    const Span span = span_within(ray, shape.bounds);
    const double after_t_min = 0.5 * (static_cast<double>(ray.t_min) + static_cast<double>(next_up(ray.t_min)));
    const double enter = std::max(span.enter, after_t_min);
    if (!(enter <= span.exit && enter < static_cast<double>(ray.t_max) && span.exit < infinity<double>))
        return {};

    const Vec<double> o(ray.origin), d(ray.direction);
    const auto along_ray = [&]<class N>(const N &t) { return shape.f(o.x + d.x * t, o.y + d.y * t, o.z + d.z * t); };
    const auto after = [&](double t) { return static_cast<T>(t) > ray.t_min; };
    const auto root = first_root(along_ray, enter, span.exit, after);
    if (!root || !in_range(ray, static_cast<T>(*root)))
        return {};
    return static_cast<T>(*root);
}

// The normal is the gradient's direction; the point is moved onto the surface by one step of Newton's along it.
template <class T, class F, class S>
Surface<T, Implicit<F, S>> surface(const Ray<T> &ray, T t, const Implicit<F, S> &shape) {
    using D = Dual<double>;
    const Vec<double> p(point_at(ray, t));
    const D by_x = shape.f(D(p.x, 1), D(p.y), D(p.z)), by_y = shape.f(D(p.x), D(p.y, 1), D(p.z)),
            by_z = shape.f(D(p.x), D(p.y), D(p.z, 1));
    const Vec<double> gradient(by_x.slope, by_y.slope, by_z.slope);
    const double steepness = dot(gradient, gradient);
    if (!(steepness > 0)) // a peak or a crossing of f = 0 has no normal: face the ray
        return {Vec<T>(p), -normalize(ray.direction), shape};
    return {Vec<T>(p - by_x.value / steepness * gradient), Vec<T>(normalize(gradient)), shape};
}

} // namespace course
