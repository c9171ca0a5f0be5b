// Chapter 03: what the light does. Left, all of it comes from one point; right, from a disk as bright along its axis.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/03_light_and_shadow/measure.hpp"
#include "chapters/03_light_and_shadow/sundial.hpp"
#include "common/publish.hpp"

using namespace course;

namespace {

// What the eye sees along the ray. With an offset, rays are float and new ones start as in note A.
template <class AnyLights> Colour radiance(const Ray<double> &ray, const SundialScene &scene, const AnyLights &lights,
                                           Random &random, double offset) {
    count_ray();
    const auto shade = [&](const auto &any_ray, const auto &spawn_at) {
        const auto hit = closest_hit(any_ray, scene);
        if (!hit)
            return Colour(0.010f, 0.014f, 0.026f);
        return with_hit(any_ray, hit, scene, [&](const auto &surface, const auto &material) {
            return direct_light(surface, facing(Vec<double>(surface.normal), ray.direction),
                                value(material.diffuse, surface), scene, lights, random, spawn_at(hit.t));
        });
    };
    if (offset < 0)
        return shade(ray, [](double) { return ExactSpawn{}; });
    const Ray<float> rounded{Vec<float>(ray.origin), normalize(Vec<float>(ray.direction))};
    return shade(rounded, [&](float t) { return ConstantOffset{rounded, t, static_cast<float>(offset)}; });
}

} // namespace

int main(int argc, char **argv) {
    return run_program("03_light_and_shadow", "Light and shadow: hard and soft", argc, argv, [](Program &program) {
        double offset = -1;
        int samples = 36;
        program.options.option("--offset", offset, {0, 1e6},
                               "Compute in float and start shadow rays this far before the hit, as the notes do");
        program.options.option("--samples", samples, {1, 65536},
                               "Shadow rays to the area light (rounded up to a square number)");
        bool measure = false;
        program.options.flag("--measure", measure, "Instead measure acne, leaks and noise: tables and plots");
        program.parse();
        if (measure) {
            Plot offsets, noise;
            const Row seed = Row().set("seed", program.seed);
            publish(program, "offset", {"Shadow rays that go wrong", seed, measure_offsets(offsets, program.seed)},
                    offsets);
            publish(program, "noise", {"Noise of a soft shadow", seed, measure_noise(noise, program.seed)}, noise);
            return;
        }

        const SundialScene scene = sundial_scene();
        const Lights hard(std::vector{lamp_point(), fill_light()});
        const int strata = static_cast<int>(std::ceil(std::sqrt(samples)));
        const Lights soft(std::vector{AreaLight<Disk<>>{lamp_disk, lamp_radiance, strata}}, std::vector{fill_light()});

        program.render(sundial_view, [&, seed = program.seed](const Viewpoint &from, int width, int height) {
            const int half = (width + 1) / 2;
            return each_pixel([&, seed, width, half, camera = Camera(from, half, height)](int x, int y) {
                if (width > 8 && (x == half - 1 || x == half))
                    return Colour(0); // a line between the two
                Random random(seed, static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) +
                                        static_cast<std::uint64_t>(x));
                return x < half ? radiance(camera.ray(x + 0.5, y + 0.5), scene, hard, random, offset)
                                : radiance(camera.ray(x - half + 0.5, y + 0.5), scene, soft, random, offset);
            });
        });
    });
}
