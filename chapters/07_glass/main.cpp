// Chapter 07: glass. Whitted's picture of 1980, rebuilt, and a drink with bubbles.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/05_texture/antialias.hpp"
#include "chapters/07_glass/glass_scenes.hpp"
#include "common/program.hpp"

using namespace course;

namespace {

// The drink stands on planks under the evening sky of chapter 05.
auto evening_drink(std::uint64_t seed) {
    const Placed<ImageTexture> planks{{paint_planks(1024, 8, seed), Border::repeat}, {0.3, 0.2}, {0.2, 0}, {0, 0.2}};
    const Object<Plane<>, Diffuse<Placed<ImageTexture>>> table{{{0, 0, 0}, {0, 1, 0}}, {planks}};
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
        program.parse();
        sampling.seed = program.seed;
        if (scene == "whitted")
            return render(program, whitted_view(), whitted_world(), limits, sampling);
        render(program, drink_view(), evening_drink(program.seed), limits, sampling);
    });
}
