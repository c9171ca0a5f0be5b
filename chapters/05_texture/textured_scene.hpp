// Lesson 05, step 7: the lesson's scene, one of every shape with its own texture, and how it is shaded.
#pragma once
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/05_texture/paint.hpp"

namespace course {

// The pictures that the scene is dressed in.
struct Wardrobe {
    ImageTexture planet, bricks, planks, target, sky;
};

inline const Vec<double> evening_sun(-0.45, 0.2, -1);

inline Wardrobe paint_wardrobe(std::uint64_t seed) {
    return {paint_planet(1024, seed + 3),
            {paint_bricks(512, 8, 8, seed), Border::repeat},
            {paint_planks(512, 4, seed), Border::repeat},
            paint_target(256),
            paint_evening(2048, evening_sun, seed + 11)};
}

// A list of objects of one kind.
template <class Shape, class Coefficient> std::vector<Object<Shape, Diffuse<Coefficient>>>
dressed(const Coefficient &texture, std::initializer_list<Shape> shapes) {
    std::vector<Object<Shape, Diffuse<Coefficient>>> objects;
    for (const Shape &shape : shapes)
        objects.push_back({shape, {texture}});
    return objects;
}

inline auto textured_scene(const Wardrobe &wardrobe) {
    const Checker marble{screen_colour(206, 200, 190), screen_colour(92, 88, 92)};
    const Checker stripes{screen_colour(214, 60, 52), screen_colour(240, 232, 216)};
    using Bricks = Placed<ImageTexture>;
    return Scene(
        dressed(Placed<Checker>{marble, {0.3, 0.2}, {0.9, 0.42}, {-0.42, 0.9}}, {Plane<>{{0, 0, 0}, {0, 1, 0}}}),
        dressed(wardrobe.planet, {Sphere<>{{0, 2.05f, 0}, 0.95f}}),
        dressed(Bricks{wardrobe.bricks, {}, {1, 0}, {0, 0.55}}, {Cylinder<>{{0, 0, 0}, {0, 1.1f, 0}, 0.8f}}),
        dressed(Bricks{wardrobe.bricks}, {Disk<>{{0, 1.1f, 0}, {0, 1, 0}, 0.8f}}),
        dressed(wardrobe.planks, {Box<>{{-3.0f, 0, -1.0f}, {-1.6f, 1.4f, 0.4f}}}),
        dressed(Placed<Checker>{stripes, {}, {12, 0}, {4, 1}}, {Cone<>{{2.3f, 2.0f, -0.4f}, {2.3f, 0, -0.4f}, 0.75f}}),
        dressed(wardrobe.target, {Disk<>{{1.35f, 0.5f, 1.2f}, {-0.25f, 0.35f, 1}, 0.52f}}),
        dressed(Placed<ImageTexture>{wardrobe.planet, {0.35, 0.35}, {0.3, 0}, {0, 0.4}},
                {affine_triangle<float>({-1.95f, 0.02f, 1.35f}, {-0.65f, 0.02f, 1.65f}, {-1.35f, 1.15f, 1.2f})}));
}

// The sun, so far away that its light falls alike on everything, and a cool lamp behind the viewer.
inline Lights<PointLight> evening_lights() {
    return Lights(std::vector{PointLight{1e6 * evening_sun, 1.2e12f * Colour(2.6f, 1.7f, 0.95f)},
                              PointLight{{45, 55, 70}, 9800.0f * Colour(0.62f, 0.66f, 0.78f)}});
}

inline Viewpoint textured_view() { return {.eye = {0.3, 2.0, 7.4}, .target = {-0.1, 1.25, 0}, .field_of_view = 38}; }

// The light along a ray: what the nearest surface scatters of the lights, or the sky.
template <class AnyScene, class AnyLights, Sky AnySky>
Colour textured_radiance(const Ray<double> &ray, const AnyScene &scene, const AnyLights &lights, const AnySky &sky,
                         Random &random) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return sky_radiance(sky, ray.direction);
    return with_hit(ray, hit, scene, [&](const auto &surface, const auto &material) {
        return direct_light(surface, facing(surface.normal, ray.direction), value(material.diffuse, surface), scene,
                            lights, random);
    });
}

} // namespace course
