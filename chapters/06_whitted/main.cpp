// Chapter 06: rays that go on after their first hit. Two mirrors face each other, and the picture has no end.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/05_texture/antialias.hpp"
#include "chapters/06_whitted/bounces.hpp"
#include "chapters/06_whitted/mirror_scene.hpp"
#include "common/program.hpp"

using namespace course;

namespace {
template <class AnyWorld> auto colours(const AnyWorld &world, const Camera &camera) {
    return [&world, camera](double x, double y, Random &random) {
        return radiance(camera.ray(x, y), world, Path{}, random);
    };
}
} // namespace

int main(int argc, char **argv) {
    return run_program("06_whitted", "Mirrors that face each other", argc, argv, [](Program &program) {
        Sampling sampling{.refined = 4};
        bool measure = false;
        auto world = mirror_world();
        program.options.option("--bounces", world.limits.bounces, {0, 1000}, "How often a ray may bounce");
        program.options.option("--samples", sampling.first, {1, 64}, "Samples per pixel and side, in every pixel");
        program.options.option("--refine", sampling.refined, {1, 64}, "The same where the first samples differ");
        program.options.flag("--measure", measure, "Instead measure error and time against the bounce limit");
        program.parse();
        sampling.seed = program.seed;
        if (measure) {
            const Viewpoint view = mirror_view();
            report_bounces(program, {compare_limits("one mirror", mirror_world(false), Path{}, view, growing_limits()),
                                     compare_limits("two mirrors", world, Path{}, view, growing_limits()),
                                     compare_limits("closed room", closed_room(), Path{}, view, growing_limits())});
            return report_early_end(program,
                                    compare_limits("closed room", closed_room(), Path{}, view, growing_patience(512)));
        }
        program.render(mirror_view(), [&](const Viewpoint &from, int width, int height) {
            return antialiased(sampling, colours(world, Camera(from, width, height)));
        });
    });
}
