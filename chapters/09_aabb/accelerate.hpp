// Lesson 09, step 8: a structure around every kind of shape of a scene that has bounds.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/09_aabb/structure.hpp"

#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace course {

// One structure over the list, or the list itself where its shapes reach to infinity.
template <template <class> class X, class Shape> auto accelerate_list(const std::vector<Shape> &list) {
    if constexpr (is_bounded<Shape>) {
        std::vector<X<Shape>> one;
        one.emplace_back(std::span<const Shape>(list));
        return one;
    } else
        return list;
}

// A shape that a scene may hold beside structures: its bounds() is missing only if is_bounded says so.
template <class Shape>
concept BoundedOrInfinite = Bounded<Shape> || !is_bounded<Shape>;

// The scene with the same ids: accelerate<Bvh>(scene).
template <template <class> class X, BoundedOrInfinite... Shapes> auto accelerate(const Scene<Shapes...> &scene) {
    return std::apply([](const auto &...lists) { return Scene(accelerate_list<X>(lists)...); }, scene.shapes);
}

// ---- Chosen at run time ---------------------------------------------------------------------------------------------

// A structure and its name on the command line. A chapter's list of the structures taught so far is a std::tuple of
// these: the last chapter's list and one line more. A list of std::strings would be made anew in every source that
// includes it, and compiled there.
template <template <class> class X> struct Named {
    std::string_view name;

    template <BoundedOrInfinite... Shapes> auto around(const Scene<Shapes...> &scene) const {
        return accelerate<X>(scene);
    }
};

// The names, as program.options.choice() takes them.
template <class... Names> std::vector<std::string> names_of(const std::tuple<Names...> &structures) {
    return std::apply([](const auto &...one) { return std::vector{std::string(one.name)...}; }, structures);
}

} // namespace course
