// Chapter 01: one ray per pixel finds the nearest sphere, and the sphere's normal gives the colour.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/01_ray_casting/forward.hpp"
#include "chapters/01_ray_casting/sunflower.hpp"
#include "common/image_files.hpp"
#include "common/program.hpp"

#include <cstdio>

using namespace course;

namespace {

// A unit normal as a colour, each component from [-1, 1] to [0, 1] as the eye judges brightness.
Colour normal_colour(const Vec<double> &normal) {
    const Colour shown = 0.5f * Colour(normal) + 0.5f;
    return {linear_from_srgb(shown.r), linear_from_srgb(shown.g), linear_from_srgb(shown.b)};
}

Colour radiance(const Ray<double> &ray, const Scene<Sphere<>> &scene) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return Colour(0.012f, 0.014f, 0.02f);
    return with_hit(ray, hit, scene, [](const auto &surface) { return normal_colour(surface.normal); });
}

void report_forward(const Scene<Sphere<>> &scene, int photons, std::uint64_t seed) {
    const ForwardTally tally =
        shoot_photons(sunflower_lamp, scene, Sphere<>{sunflower_view.eye, 0.02f}, 4, photons, seed);
    const auto percent = [&](std::uint64_t n) {
        return 100 * static_cast<double>(n) / static_cast<double>(tally.shot);
    };
    std::printf("forward:  %llu rays left the light, %.3f %% met a sphere, %llu reached the eye (%.6f %%)\n"
                "backward: every ray from the eye gives one pixel its colour (100 %%)\n",
                static_cast<unsigned long long>(tally.shot), percent(tally.hit_something),
                static_cast<unsigned long long>(tally.reached_eye), percent(tally.reached_eye));
}

} // namespace

int main(int argc, char **argv) {
    return run_program("01_ray_casting", "Ray casting: one ray per pixel", argc, argv, [](Program &program) {
        int photons = 0;
        program.options.option("--forward", photons, {1, 1e9}, "Instead shoot this many rays from the light");
        program.parse();

        const Scene<Sphere<>> scene = sunflower();
        if (photons)
            return report_forward(scene, photons, program.seed);
        program.render(sunflower_view, [&scene](const Viewpoint &from, int width, int height) {
            return each_pixel([&scene, camera = Camera(from, width, height)](int x, int y) {
                return radiance(camera.ray(x + 0.5, y + 0.5), scene);
            });
        });
    });
}
