// What the claims about acceleration structures are measured on.
#pragma once
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/16_comparison/built_scenes.hpp"
#include "chapters/16_comparison/hall.hpp"
#include "chapters/16_comparison/rays.hpp"
#include "chapters/16_comparison/scattered.hpp"
#include "common/timing.hpp"
#include "tests/claims/claim.hpp"

namespace course {

// In the small, with no file to read, or one of chapter 16's as they are in full.
inline TestScene claim_scene(const std::string &name, const ClaimOptions &options) {
    const Vec<double> front(0.3, 0.35, 1);
    if (!options.quick)
        return std::ranges::find(scene_makers(), name, &SceneMaker::name)->make(false, options.seed);
    if (name == "soup")
        return seen_from(name, triangle_soup(10'000, options.seed), front);
    if (name == "needles")
        return seen_from(name, needles(3'000, options.seed), front);
    if (name == "rings")
        return seen_from(name, rings(4, 16, 8, options.seed), front);
    if (name == "stadium") {
        TestScene scene = seen_from(name, triangles(ball(4)), front);
        scene.triangles = in_stadium(std::move(scene.triangles));
        return scene;
    }
    TestScene scene = std::ranges::find(scene_makers(), name, &SceneMaker::name)->make(true, options.seed);
    if (name == "hall")
        scene.triangles = hall(8, 1);
    return scene;
}

// The scene with a surface like most models'.
inline std::string model_scene(const ClaimOptions &options) { return options.quick ? "rings" : "bunny"; }

inline std::vector<Ray<double>> primary_rays(const TestScene &scene, int side) {
    const Camera camera(scene.view, side, side);
    std::vector<Ray<double>> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

template <class X> X around(const TestScene &scene) { return X(std::span<const Triangle<>>(scene.triangles)); }

// A loop over all rays, to be timed.
template <class Rays, class X> auto trace_all(const Rays &rays, const X &structure) {
    return [&] {
        for (const auto &ray : rays)
            keep(closest_hit(ray, structure));
    };
}

} // namespace course
