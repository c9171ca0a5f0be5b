// Lesson 04, step 3: one picture shaded by the map and by shadow rays, and where the two differ.
#pragma once
#include "chapters/04_shadow_map/cases.hpp"

namespace course {

// A pixel of the sundial in both ways.
struct Compared {
    Colour by_map{0.010f, 0.014f, 0.026f}, by_rays = by_map;
    float map_lit = 0, ray_lit = 0; // the shares of the lamp's light
};

// One ray from the eye, shaded in both ways. The weak second light, at the eye, has shadow rays in both.
template <class AnyScene>
Compared compare(const Ray<double> &ray, const AnyScene &scene, const ShadowMap &map, const MapLookup &how) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return {};
    return with_hit(ray, hit, scene, [&](const auto &surface, const auto &material) {
        Random unused(0);
        const Vec<double> normal = facing(surface.normal, ray.direction);
        const Colour &diffuse = value(material.diffuse, surface);
        const Colour fill = direct_light(surface, normal, diffuse, scene, fill_light(), unused);
        Compared result{fill, fill};
        for_each_sample(lamp_point(), surface.point, unused, [&](const LightSample &sample) {
            const double cosine = dot(sample.direction, normal);
            if (!(cosine > 0))
                return;
            const Colour full = static_cast<float>(cosine) * diffuse * sample.radiance;
            result.map_lit = map.lit(surface.point, normal, how);
            result.ray_lit = lit_by(sample, surface, scene);
            result.by_map += result.map_lit * full;
            result.by_rays += result.ray_lit * full;
        });
        return result;
    });
}

// Grey where both agree; orange where only the map sees a shadow, blue where only the rays do.
inline Colour difference_colour(const Compared &both) {
    const Colour grey(0.25f * dot(both.by_rays, Colour(0.2126f, 0.7152f, 0.0722f)));
    const float more = both.map_lit - both.ray_lit;
    return grey + (more > 0 ? more * Colour(0.05f, 0.35f, 1) : -more * Colour(1, 0.35f, 0));
}

} // namespace course
