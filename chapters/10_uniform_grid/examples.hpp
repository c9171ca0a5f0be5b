// Lesson 10, step 7: the three scenes on which structures are measured, and the rays for them.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"

#include <string>
#include <vector>

namespace course {

struct Example {
    std::string name;
    std::vector<Triangle<>> triangles;
    Viewpoint view;
    int pixels; // across and down: few where every ray is slow
};

inline std::vector<Example> examples(const std::string &mesh_file, std::uint64_t seed) {
    const auto bunny = model(mesh_file);
    const Viewpoint view = seen_whole(box_around(bunny));
    const auto even = soup(bunny.size(), seed);
    return {{"soup", even, seen_whole(box_around(even)), 64},
            {mesh_file.empty() ? "bunny" : "mesh", bunny, view, 64},
            {mesh_file.empty() ? "bunny in a stadium" : "mesh in a stadium", in_stadium(bunny), view, 16}};
}

inline std::vector<Ray<double>> rays_of(const Example &example) {
    const Camera camera(example.view, example.pixels, example.pixels);
    std::vector<Ray<double>> rays;
    for (int y = 0; y < example.pixels; ++y)
        for (int x = 0; x < example.pixels; ++x)
            rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

} // namespace course
