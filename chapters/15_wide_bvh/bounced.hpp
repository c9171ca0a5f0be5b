// Lesson 15, step 12: chapter 09's exhibit with light that has bounced once, so that rays of every kind are traced.
#pragma once
#include "chapters/09_aabb/exhibit.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// A direction on the normal's side, the likelier the nearer to it (with the cosine).
inline Vec<double> scattered_direction(const Vec<double> &normal, Random &random) {
    const double z = random.uniform(-1, 1), angle = 2 * pi * random.uniform(), ring = std::sqrt(1 - z * z);
    const Vec<double> sum = normal + Vec<double>(ring * std::cos(angle), ring * std::sin(angle), z);
    return dot(sum, sum) > 1e-6 ? normalize(sum) : normal;
}

// What comes back along the ray: light straight from the lights and, `bounces` times on, light from whatever the
// surface faces. Where such a ray meets nothing, it brings what chapter 08 takes for the light of a whole room.
template <class AnyScene> Colour bounced_light(const Ray<double> &ray, const AnyScene &scene, const Studio &studio,
                                               Random &random, int bounces, const Colour &missed) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return missed;
    return with_hit(ray, hit, scene, [&](const auto &surface, const auto &material) {
        const Vec<double> flat = facing(surface.normal, ray.direction);
        const bool of_mesh = hit.id < size(studio.mesh());
        const Vec<double> shaded = of_mesh ? shading_normal(studio.mesh(), hit.id, surface.point) : surface.normal;
        const Vec<double> normal = facing(shaded, ray.direction);
        const Colour diffuse = value(material.diffuse, surface);
        const Colour direct = direct_light(surface, normal, diffuse, scene, studio.lights, random);
        if (bounces == 0)
            return direct + diffuse * ambient(normal);
        const Vec<double> way = scattered_direction(flat, random);
        return direct +
               diffuse * bounced_light(spawn_ray(surface, way), scene, studio, random, bounces - 1, ambient(way));
    });
}

// Sample i of samples² in a pixel, each in a cell of its own: colour(x, y, i, scene).
inline auto bounced_exhibit(const Studio &studio, const Camera &camera, int samples, std::uint64_t seed) {
    return [&studio, camera, samples, seed](int x, int y, int i, const auto &scene) {
        const auto place = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);
        Random random(seed + static_cast<std::uint64_t>(i), place);
        const double across = (i % samples + random.uniform()) / samples,
                     down = (i / samples + random.uniform()) / samples;
        const Ray<double> ray = camera.ray(x + across, y + down);
        return bounced_light(ray, scene, studio, random, 1, backdrop(ray.direction));
    };
}

} // namespace course
