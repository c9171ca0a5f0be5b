// Lesson 16, step 16: the hall with its guest, in sunlight and in the light that the sky and the walls send back.
#pragma once
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/05_texture/antialias.hpp"
#include "chapters/05_texture/sky.hpp"
#include "chapters/09_aabb/accelerate.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "chapters/16_comparison/built_scenes.hpp"
#include "chapters/16_comparison/hall.hpp"
#include "chapters/16_comparison/landscape.hpp"
#include "chapters/16_comparison/rays.hpp"
#include "common/errors.hpp"

#include <vector>

namespace course {

using Painted = Object<Triangle<>, Diffuse<>>;

inline void paint(std::vector<Painted> &list, const Triangles &triangles, const Colour &colour) {
    for (const Triangle<> &triangle : triangles)
        list.push_back({triangle, {colour}});
}

// The bunny, 1.6 high, with its feet at `foot`; where it is not installed, a sphereflake stands in.
inline Triangles guest(const Vec<double> &foot) {
    Triangles list;
    try {
        list = bunny();
    } catch (const InputError &) {
        list = sphereflake(3, 3);
    }
    const Box<float> box = bounds(std::span<const Triangle<>>(list));
    const double scale = 1.6 / extent(box).y;
    const Vec<double> from(centre(box).x, box.lo.y, centre(box).z);
    for (Triangle<> &triangle : list)
        for (Vec<float> *corner : {&triangle.a, &triangle.b, &triangle.c})
            *corner = Vec<float>(foot + scale * (Vec<double>(*corner) - from));
    return list;
}

// `hills` says how finely the land around is cut: into 2 hills² triangles.
inline Scene<Painted> hall_scene(int hills) {
    const Colour stone(0.72f, 0.66f, 0.56f), slate(0.33f, 0.37f, 0.42f), fur(0.62f, 0.33f, 0.17f);
    std::vector<Painted> list;
    paint(list, hall(8, 4), stone);
    Triangles plinth;
    add_box(plinth, {-0.9, 0, 3.1}, {0.9, 0.25, 4.9});
    add_box(plinth, {-0.7, 0.25, 3.3}, {0.7, 1.0, 4.7});
    add_box(plinth, {-0.8, 1.0, 3.2}, {0.8, 1.1, 4.8});
    paint(list, plinth, slate);
    paint(list, guest({0, 1.1, 4}), fur);
    Triangles land; // flat around the hall, and rising towards the horizon
    add_patch(land, hills, hills, [](double u, double v) {
        const double x = 2 * u - 1, z = 1 - 2 * v, rise = std::clamp(2 * std::hypot(x, z) - 0.2, 0.0, 1.0);
        return Vec<double>(150 * x, rise * (70 * terrain_height(x, z, 1) - 18) - 0.3, 150 * z);
    });
    paint(list, land, {0.20f, 0.26f, 0.10f});
    return Scene(std::move(list));
}

inline const Viewpoint hall_view{.eye = {1.25, 1.6, 8.5}, .target = {-0.2, 2.2, 3}, .field_of_view = 54};
inline const GradientSky hall_sky{{0.75f, 0.85f, 1.0f}, {0.25f, 0.45f, 0.9f}, {0.3f, 0.28f, 0.25f}};

// A low sun that shines between the columns on the left. Its disk is a little larger than the real one's.
inline Lights<AreaLight<Disk<>>> hall_sun() {
    const Vec<float> towards = normalize(Vec<float>(-1.0f, 0.62f, 0.42f));
    return Lights(
        std::vector{AreaLight<Disk<>>{{200.0f * towards, -towards, 2.5f}, 22'000.0f * Colour(1, 0.86f, 0.66f), 1}});
}

// What stands in for the light of all further bounces.
inline const Colour ambient(0.22f, 0.21f, 0.20f);

// The light along the ray: the sun's, and what comes in from one random direction, `bounces` times over. These are the
// chapter's rays: primary, shadow and bounce.
template <class AnyScene, class AnyLights>
Colour light_along(const Ray<double> &ray, const AnyScene &scene, const AnyLights &sun, Random &random, int bounces) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return sky_radiance(hall_sky, ray.direction);
    return with_hit(ray, hit, scene, [&](const auto &surface, const Diffuse<> &material) {
        const Vec<double> normal = facing(surface.normal, ray.direction);
        Colour sum = direct_light(surface, normal, material.diffuse, scene, sun, random);
        if (bounces == 0)
            sum += material.diffuse * ambient;
        else
            sum += material.diffuse * light_along(spawn_ray(surface, Vec<double>(cosine_direction(normal, random))),
                                                  scene, sun, random, bounces - 1);
        return sum;
    });
}

// Brightness as a film would answer to it: highlights fade out instead of being cut off.
inline Colour film(const Colour &light) { return 1.0f - exp(-light); }

} // namespace course
