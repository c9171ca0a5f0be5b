// Lesson 03, step 2: a shadow ray asks only whether anything is in the way, and stops at the first answer.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"

#include <algorithm>

namespace course {

// Whether the ray meets the shape within its interval. Scenes and structures have overloads under the same name.
template <class R, class Shape>
    requires Primitive<Shape, R>
bool any_hit(const R &ray, const Shape &shape) {
    ray.counts().test();
    return intersect(ray, shape).has_value();
}

template <class R, class... Shapes> bool any_hit(const R &ray, const Scene<Shapes...> &scene) {
    const auto hits = [&](const auto &shape) { return any_hit(ray, shape); };
    return std::apply([&](const auto &...lists) { return (std::ranges::any_of(lists, hits) || ...); }, scene.shapes);
}

} // namespace course
