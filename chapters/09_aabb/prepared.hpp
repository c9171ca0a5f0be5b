// Lesson 09, step 5b: what a ray works out once, before it meets many shapes of one kind.
#pragma once
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/08_mesh/triangle.hpp"

#include <optional>

namespace course {

// A ray that carries what the triangle test would otherwise work out anew for each triangle. Like the counters it rides
// on the ray's type, so the searches in between know nothing of it. Its origin and direction are not to be changed.
template <class R> struct Sheared : R {
    Shear shear;

    explicit Sheared(const R &ray) : R(ray), shear(ray) {}
};

template <class R, class S>
std::optional<typename R::Scalar> intersect(const Sheared<R> &ray, const Triangle<S> &triangle) {
    return intersect(ray, ray.shear, triangle);
}

// The ray as the searches of a structure over Shape shall use it: as it is, unless there is something to prepare.
template <class Shape> struct Preparation {
    template <class R> static R of(const R &ray) { return ray; }
};
template <class S> struct Preparation<Triangle<S>> {
    template <class R> static Sheared<R> of(const R &ray) { return Sheared<R>(ray); }
};
template <class Shape, class Material> struct Preparation<Object<Shape, Material>> : Preparation<Shape> {};

template <class Shape, class R> auto prepared(const R &ray) { return Preparation<Shape>::of(ray); }

} // namespace course
