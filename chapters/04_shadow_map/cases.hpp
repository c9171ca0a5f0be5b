// Lesson 04: places of the sundial at which a map's answer is compared with a shadow ray's.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/03_light_and_shadow/sundial.hpp"
#include "chapters/04_shadow_map/shadow_map.hpp"

namespace course {

// The sundial as its lamp sees it, with all that casts a shadow into the picture.
inline const Viewpoint lamp_view{.eye = Vec<double>(lamp_disk.centre), .target = {0, 0.7, -0.3}, .field_of_view = 36};

// The sundial as the panels show it, and as the errors are counted.
inline const Viewpoint panel_view{.eye = sundial_view.eye, .target = {0.75, 1.12, -0.2}, .field_of_view = 29};

// A place that the eye sees and that faces the lamp, and whether a shadow ray reaches the lamp from there.
struct MapCase {
    Vec<double> point, normal;
    bool lit;
};

// One case for each pixel of a picture of the sundial of this size whose surface faces the lamp.
inline std::vector<MapCase> sundial_cases(const SundialScene &scene, int width, int height) {
    const Camera camera(panel_view, width, height);
    std::vector<MapCase> cases;
    for (int i = 0; i < width * height; ++i) {
        const auto ray = camera.ray(i % width + 0.5, i / width + 0.5);
        const auto hit = closest_hit(ray, scene);
        if (!hit)
            continue;
        with_hit(ray, hit, scene, [&](const auto &surface, const auto &) {
            const Vec<double> normal = facing(surface.normal, ray.direction);
            const LightSample sample = sample_towards(lamp_point().position, surface.point);
            if (dot(sample.direction, normal) > 0)
                cases.push_back({surface.point, normal, lit_by(sample, surface, scene)});
            return 0;
        });
    }
    return cases;
}

// How many cases of a million a map gets wrong: shadow where there is light, and light where there is shadow. A lookup
// that is partly lit counts in part.
struct MapErrors {
    double false_shadow = 0, false_light = 0;
};
inline MapErrors errors_of(const ShadowMap &map, const MapLookup &how, const std::vector<MapCase> &cases) {
    MapErrors errors;
    for (const MapCase &c : cases) {
        const double lit = map.lit(c.point, c.normal, how);
        (c.lit ? errors.false_shadow : errors.false_light) += 1e6 * (c.lit ? 1 - lit : lit);
    }
    const auto count = static_cast<double>(cases.size());
    return {errors.false_shadow / count, errors.false_light / count};
}

// The very points that the map's rays have met, stored in T: each is lit, and its depth stands in the map.
template <class T> std::vector<MapCase> texel_cases(const SundialScene &scene, const LightView &view, int resolution) {
    std::vector<MapCase> cases;
    for (int i = 0; i < resolution * resolution; ++i) {
        const auto ray = view.ray((i % resolution + 0.5) / resolution, (i / resolution + 0.5) / resolution);
        if (const auto hit = closest_hit(ray, scene))
            cases.push_back({Vec<double>(Vec<T>(point_at(ray, hit.t))), -normalize(ray.direction), true});
    }
    return cases;
}

} // namespace course
