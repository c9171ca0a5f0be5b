// Lesson 01, step 5: a scene is a list of shapes, and its type says which kinds it holds.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"
#include "chapters/01_ray_casting/surface.hpp"

#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace course {

// One vector per kind of shape: Scene<Sphere<>> holds spheres and its loops know of nothing else. The primitives are
// numbered through, kind by kind.
template <class... Shapes> struct Scene {
    std::tuple<std::vector<Shapes>...> shapes;

    explicit Scene(std::vector<Shapes>... lists) : shapes(std::move(lists)...) {}
};

// Calls visit(shape) for every shape, in the order of the ids. The loop over kinds is unrolled by the compiler.
template <class Visit, class... Shapes> void for_each_shape(const Scene<Shapes...> &scene, Visit &&visit) {
    const auto visit_list = [&](const auto &list) {
        for (const auto &shape : list)
            visit(shape);
    };
    std::apply([&](const auto &...lists) { (visit_list(lists), ...); }, scene.shapes);
}

template <class... Shapes> Id size(const Scene<Shapes...> &scene) {
    Id count = 0;
    for_each_shape(scene, [&](const auto &shape) { count += size(shape); });
    return count;
}

// The nearest hit among all shapes: brute force, the answer that every acceleration structure must reproduce.
template <class R, class... Shapes> Hit<typename R::Scalar> closest_hit(R ray, const Scene<Shapes...> &scene) {
    Hit<typename R::Scalar> best;
    Id base = 0;
    for_each_shape(scene, [&](const auto &shape) {
        closest_of(ray, shape, base, best);
        base += size(shape);
    });
    return best;
}

// f(surface, context...) for the primitive that was hit. Containers pass the call on to the shape that holds the id;
// what they know about it (from chapter 03 on, its material) joins the context.
template <class R, class Shape, class F, class... Context>
    requires Primitive<Shape, R>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const Shape &shape, F &&f, const Context &...context) {
    return f(surface(ray, hit.t, shape), context...);
}

// The hit must be one of this scene's.
template <class R, class... Shapes, class F, class... Context> auto
with_hit(const R &ray, Hit<typename R::Scalar> hit, const Scene<Shapes...> &scene, F &&f, const Context &...context) {
    using Result = std::common_type_t<decltype(with_hit(ray, hit, std::declval<const Shapes &>(), f, context...))...>;
    std::optional<Result> result;
    for_each_shape(scene, [&](const auto &shape) {
        if (result)
            return;
        const Id count = size(shape);
        if (hit.id < count)
            result = with_hit(ray, hit, shape, f, context...);
        else
            hit.id -= count;
    });
    return *result;
}

} // namespace course
