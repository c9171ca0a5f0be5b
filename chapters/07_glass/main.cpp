// Chapter 07: glass. Whitted's picture of 1980, rebuilt, and a drink with bubbles.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/05_texture/antialias.hpp"
#include "chapters/06_whitted/mirror_scene.hpp"
#include "chapters/07_glass/glass_scenes.hpp"
#include "chapters/07_glass/holds.hpp"
#include "chapters/07_glass/measurements.hpp"
#include "common/program.hpp"

using namespace course;

namespace {

// The drink stands on a table cloth under the evening sky of chapter 05.
auto evening_drink(std::uint64_t seed) {
    const Placed<Checker> cloth{
        {screen_colour(226, 218, 200), screen_colour(150, 172, 160)}, {0.2, 0.1}, {1.6, 0}, {0, 1.6}};
    const Object<Plane<>, Diffuse<Placed<Checker>>> table{{{0, 0, 0}, {0, 1, 0}}, {cloth}};
    return drink_world(juice, table, ImageSky{paint_evening(2048, {-0.5, 0.3, -1}, seed + 11)});
}

template <class AnyWorld>
void render(Program &program, const Viewpoint &view, AnyWorld world, const Limits &limits, const Sampling &sampling) {
    world.limits = limits;
    program.render(view, [&](const Viewpoint &from, int width, int height) {
        return antialiased(sampling, [&, camera = Camera(from, width, height)](double x, double y, Random &random) {
            return radiance(camera.ray(x, y), world, Path{}, random);
        });
    });
}

static_assert(holds<decltype(whitted_world()), Dielectric> && !holds<decltype(mirror_world()), Dielectric>);

void measure(const Program &program, const Limits &limits) {
    measure_fresnel(program);
    Report report{"What it costs to model everything", {}, {}};
    report.results = {everything_row("mirrors (no glass)", mirror_world(), limits, mirror_view()),
                      everything_row("Whitted's spheres", whitted_world(), limits, whitted_view())};
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("everything.json"), report);
    std::vector<Limits> patience; // ten bounces, so that even a picture that cuts off nothing gets done
    for (const float weight : {0x1p-8f, 0x1p-12f, 0x1p-16f, 0x1p-20f, 0x1p-24f, 0.0f})
        patience.push_back({.bounces = 10, .least_weight = weight});
    report_early_end(program, compare_limits("Whitted's spheres", whitted_world(), Path{}, whitted_view(), patience));
}

} // namespace

int main(int argc, char **argv) {
    return run_program("07_glass", "Whitted's picture: mirrors and glass", argc, argv, [](Program &program) {
        Sampling sampling{.refined = 4};
        Limits limits{.least_weight = 0x1p-12f};
        std::string scene = "whitted";
        program.options.choice("--scene", scene, {"whitted", "drink"}, "What to show");
        program.options.option("--bounces", limits.bounces, {0, 1000}, "How often a ray may bounce");
        program.options.option("--samples", sampling.first, {1, 64}, "Samples per pixel and side, in every pixel");
        program.options.option("--refine", sampling.refined, {1, 64}, "The same where the first samples differ");
        bool measuring = false;
        program.options.flag("--measure", measuring,
                             "Instead measure Fresnel's errors, and what modelling everything costs");
        program.parse();
        sampling.seed = program.seed;
        if (measuring)
            return measure(program, limits);
        if (scene == "whitted")
            return render(program, whitted_view(), whitted_world(), limits, sampling);
        render(program, drink_view(), evening_drink(program.seed), limits, sampling);
    });
}
