// Lesson 06, step 2: materials that send rays on, glow, or do several things at once.
#pragma once
#include "chapters/05_texture/texture.hpp"

#include <tuple>

namespace course {

// Mirrors the share `reflection` of the light (A 3.3.1 without refraction).
template <class Coefficient = Colour> struct Mirror { Coefficient reflection; };

// Shines by itself, with the same radiance in all directions (A 3.3.4).
template <class Coefficient = Colour> struct Glow { Coefficient glow; };

// Several materials on one surface, whose light adds up: a polished floor is Sum<Diffuse<Checker>, Mirror<>>.
template <class... Parts> struct Sum {
    std::tuple<Parts...> parts;

    explicit Sum(Parts... materials) : parts(std::move(materials)...) {}
};

} // namespace course
