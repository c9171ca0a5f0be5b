// Lesson 03, step 1: an object is a shape with a material, and itself a shape.
#pragma once
#include "chapters/03_light_and_shadow/any_hit.hpp"

#include <utility>

namespace course {

// The shape may be a primitive, or a container or structure of primitives that all share the material.
template <class Shape, class Material> struct Object {
    Shape shape;
    Material material;
};

template <class Shape, class Material> Id size(const Object<Shape, Material> &object) { return size(object.shape); }

template <class R, class Shape, class Material>
Hit<typename R::Scalar> closest_hit(const R &ray, const Object<Shape, Material> &object) {
    return closest_hit(ray, object.shape);
}

template <class R, class Shape, class Material> bool any_hit(const R &ray, const Object<Shape, Material> &object) {
    return any_hit(ray, object.shape);
}

// The material joins the context: f(surface, material).
template <class R, class Shape, class Material, class F, class... Context>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const Object<Shape, Material> &object, F &&f,
              const Context &...context) {
    return with_hit(ray, hit, object.shape, f, context..., object.material);
}

} // namespace course
