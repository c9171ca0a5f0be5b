// Chapter 16: every structure, every scene, every ray's answer verified. Read README.md.
#include "chapters/16_comparison/picture.hpp"
#include "chapters/16_comparison/run.hpp"
#include "common/program.hpp"

#include <chrono>
#include <cstdio>

using namespace course;

namespace {

void render_hall(Program &program, int samples, int hills) {
    const auto list = hall_scene(hills);
    const auto start = std::chrono::steady_clock::now();
    const auto scene = accelerate<Bvh>(list);
    const std::chrono::duration<double> build = std::chrono::steady_clock::now() - start;
    std::printf("%u triangles, their tree built in %.2f s, peak memory %.1f GiB\n", size(scene), build.count(),
                peak_gib());
    const auto sun = hall_sun();
    program.render(hall_view, [&, seed = program.seed](const Viewpoint &view, int width, int height) {
        return each_pixel([&, seed, width, camera = Camera(view, width, height)](int x, int y) {
            Random random(seed, static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) +
                                    static_cast<std::uint64_t>(x));
            const auto light = [&](double across, double down, Random &dice) {
                return light_along(camera.ray(across, down), scene, sun, dice, 1);
            };
            return film(stratified_mean(x, y, samples, random, light, [](const Colour &) {}));
        });
    });
}

} // namespace

int main(int argc, char **argv) {
    int compared = 0;
    const auto body = [&](Program &program) {
        Request request;
        bool only_picture = false, only_compare = false;
        int samples = 3, hills = 160;
        program.options.option("--samples", samples, {1, 64}, "The picture has so many samples squared in a pixel");
        program.options.option("--hills", hills, {1, 4000}, "The picture's hills have twice so many triangles squared");
        program.options.flag("--picture", only_picture, "Only the picture");
        program.options.flag("--compare", only_compare, "Only the comparison, in full unless --quick");
        program.options.flag("--quick", request.quick, "Only the comparison, on small scenes and with few rays");
        program.options.option("--scene", request.scenes, "Compare on this scene (may repeat)");
        program.options.option("--mesh", request.meshes, "Compare on this mesh: OBJ, OFF, PLY or STL (may repeat)");
        program.options.option("--structure", request.structures, "Compare this structure or peer (may repeat)");
        program.options.option("--report", request.report, "Where the report goes: FILE.json, FILE.md, FILE_*.svg");
        program.parse();

        request.seed = program.seed;
        const bool narrowed = !request.scenes.empty() || !request.meshes.empty() || !request.structures.empty();
        if (!only_compare && !request.quick && !narrowed)
            request.brief = true;
        if (request.brief)
            render_hall(program, samples, hills);
        request.quick |= !only_compare;
        if (!only_picture && program.exit_status() == 0 && !program.in_window())
            compared = run_comparison(request);
    };
    const int status =
        run_program("16_comparison", "The comparison: every structure, every ray verified", argc, argv, body);
    return status ? status : compared;
}
