// Lesson 09, step 5b: what a ray works out once, before it meets many shapes of one kind.
#pragma once
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/08_mesh/triangle.hpp"

namespace course {

// The ray as the searches of a structure over Shape shall use it: as it is, unless there is something to prepare.
template <class Shape> struct Preparation {
    template <class R> static R of(const R &ray) { return ray; }
};
template <class S> struct Preparation<Triangle<S>> {
    template <class R> static auto of(const R &ray) { return with_shear(ray); } // chapter 08
};
template <class Shape, class Material> struct Preparation<Object<Shape, Material>> : Preparation<Shape> {};

template <class Shape, class R> auto prepared(const R &ray) { return Preparation<Shape>::of(ray); }

} // namespace course
