// Lesson 06, step 3: Whitted's recursion. Each surface adds its own light and asks what its mirror direction brings.
#pragma once
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/05_texture/sky.hpp"
#include "chapters/06_whitted/materials.hpp"
#include "chapters/06_whitted/mirror.hpp"

#include <algorithm>

namespace course {

// When to stop.
struct Limits {
    int bounces = 32; // a ray that has bounced so often is not followed further

    // Nor is one that carries less than this share of the pixel's light: a twentieth of the smallest step that a pixel
    // of 8 bits can show, which is 1/255/12.92 in the darkest tones.
    float least_weight = 0x1p-16f;

    Colour beyond{0}; // what such a ray is taken to bring
};

template <class AnyScene, class AnyLights, Sky AnySky> struct World {
    AnyScene scene;
    AnyLights lights;
    AnySky sky;
    Limits limits = {};
};

// What is known of a ray besides its line: the share of the pixel's light that it carries (A 3.1.2's intensity factor),
// and how often it has bounced. Chapter 07's paths know their medium as well.
struct Path {
    Colour weight{1};
    int bounces = 0;
};

// How a ray came to a surface: all that a material needs to answer.
template <class World, class AnyPath> struct Arrival {
    const Ray<double> &ray;
    const World &world;
    const AnyPath &path;
    Random &random;
};

inline float largest(const Colour &c) { return std::max({c.r, c.g, c.b}); }

// The light along a ray: the sky's, or what the nearest surface's material makes of it.
template <class World, class AnyPath>
Colour radiance(const Ray<double> &ray, const World &world, const AnyPath &path, Random &random) {
    count_ray();
    const auto hit = closest_hit(ray, world.scene);
    if (!hit)
        return sky_radiance(world.sky, ray.direction);
    return with_hit(ray, hit, world.scene, [&](const auto &surface, const auto &material) {
        return shade(material, surface, Arrival<World, AnyPath>{ray, world, path, random});
    });
}

// The light that a bounce ray brings, times the share of it that the surface passes on. `path` is the arriving ray's;
// a material that changes more than the weight hands over a changed one.
template <class World, class AnyPath>
Colour follow(const Ray<double> &bounce, const Colour &share, const Arrival<World, AnyPath> &arrival, AnyPath path) {
    path.weight *= share;
    ++path.bounces;
    if (path.bounces > arrival.world.limits.bounces || largest(path.weight) < arrival.world.limits.least_weight)
        return share * arrival.world.limits.beyond;
    return share * radiance(bounce, arrival.world, path, arrival.random);
}

// What each material makes of an arriving ray. A new material needs only its overload of shade().
template <class Coefficient, class T, class Shape, class World, class AnyPath> Colour
shade(const Diffuse<Coefficient> &material, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    return direct_light(surface, facing(surface.normal, arrival.ray.direction), value(material.diffuse, surface),
                        arrival.world.scene, arrival.world.lights, arrival.random);
}

template <class Coefficient, class T, class Shape, class World, class AnyPath>
Colour shade(const Glow<Coefficient> &material, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &) {
    return value(material.glow, surface);
}

template <class Coefficient, class T, class Shape, class World, class AnyPath> Colour
shade(const Mirror<Coefficient> &material, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    const Ray<double> bounce = spawn_ray(surface, mirror_direction(arrival.ray.direction, surface.normal));
    return follow(bounce, value(material.reflection, surface), arrival, arrival.path);
}

template <class... Parts, class T, class Shape, class World, class AnyPath>
Colour shade(const Sum<Parts...> &material, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    return std::apply([&](const auto &...parts) { return (shade(parts, surface, arrival) + ...); }, material.parts);
}

} // namespace course
