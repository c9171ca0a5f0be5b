// Lesson 03, step 1: materials are types, and their coefficients may vary over the surface.
#pragma once
#include "chapters/01_ray_casting/surface.hpp"

namespace course {

// What a coefficient is at a point of a surface. A colour is the same everywhere; chapter 05 adds textures by
// overloads of value().
template <class T, class Shape> const Colour &value(const Colour &constant, const Surface<T, Shape> &) {
    return constant;
}

// A surface that scatters light alike in all directions (Lambert): the share of light that it scatters, per channel.
template <class Coefficient = Colour> struct Diffuse { Coefficient diffuse; };

} // namespace course
