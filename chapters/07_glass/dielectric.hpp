// Lesson 07, step 2: glass and liquids. A surface between two clear media divides the light that meets it.
#pragma once
#include "chapters/06_whitted/whitted.hpp"
#include "chapters/07_glass/optics.hpp"

namespace course {

// A medium that light passes unhindered. The refractive index is a coefficient: a number, or a texture's (Scaled).
template <class Index = float> struct Clear { Index index = 1; };

// A medium that swallows light along its way: `absorption` is per unit length and channel (Beer and Lambert).
template <class Index = float> struct Tinted {
    Index index;
    Colour absorption;
};

// The share of the light that is left after a way of this length.
template <class Index> Colour transmittance(const Clear<Index> &, double) { return Colour(1); }
template <class Index> Colour transmittance(const Tinted<Index> &medium, double length) {
    return exp(-static_cast<float>(length) * medium.absorption);
}

// A coefficient that is 1 and costs nothing.
struct White {};
template <class T, class Shape> Colour value(White, const Surface<T, Shape> &) { return Colour(1); }

// A boundary knows the media on both of its sides: `inside` lies behind the normal, `outside` before it. So a ray need
// not remember where it is: an air bubble in glass is a sphere with air inside and glass outside. Reflection and
// transmission scale what Fresnel's equations give (A's r and t, eq. 52 and 60).
template <class Inside = Clear<>, class Outside = Clear<>, class Reflection = White, class Transmission = White>
struct Dielectric {
    Inside inside;
    Outside outside;
    Reflection reflection;
    Transmission transmission;
};

// Light that comes through `from`, at the boundary to `to`.
template <class From, class To, class R, class T, class S, class Shape, class World, class AnyPath>
Colour divide(const From &from, const To &to, const R &reflection, const T &transmission,
              const Surface<S, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    const Vec<double> direction = normalize(arrival.ray.direction);
    const double cos_i = std::min(std::abs(dot(direction, surface.normal)), 1.0);
    const float n_from = value(from.index, surface), n_to = value(to.index, surface);
    const Fresnel shares = fresnel(cos_i, n_from, n_to);

    // What is left of the light after its way through the medium behind it.
    const Colour left = transmittance(from, length(surface.point - arrival.ray.origin));
    AnyPath path = arrival.path;
    path.weight *= left;

    Colour sum = follow(spawn_ray(surface, mirror_direction(direction, surface.normal)),
                        static_cast<float>(shares.reflected) * value(reflection, surface), arrival, path);
    if (shares.transmitted > 0)
        sum += follow(spawn_ray(surface, refracted_direction(direction, surface.normal, n_from, n_to)),
                      static_cast<float>(shares.transmitted) * value(transmission, surface), arrival, path);
    return left * sum;
}

template <class... Kinds, class T, class Shape, class World, class AnyPath> Colour
shade(const Dielectric<Kinds...> &glass, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    if (dot(arrival.ray.direction, surface.normal) < 0)
        return divide(glass.outside, glass.inside, glass.reflection, glass.transmission, surface, arrival);
    return divide(glass.inside, glass.outside, glass.reflection, glass.transmission, surface, arrival);
}

} // namespace course
