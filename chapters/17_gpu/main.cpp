// Chapter 17: the tracer as a fragment shader. Whitted's picture, on whatever OpenGL this machine has.
#include "chapters/17_gpu/live.hpp"
#include "chapters/17_gpu/report.hpp"
#include "common/image_files.hpp"
#include "common/output_files.hpp"
#include "common/program.hpp"

#include <cstdio>

using namespace course;

namespace {

// The same samples on the CPU in double, and how far the two pictures are apart.
void compare(const Program &program, const Exhibit &exhibit, const Picture &drawn, int samples) {
    const RenderedPicture exact = cpu_picture(exhibit, program.width, program.height, samples, program.seed);
    const ImageDifference apart = difference(exact.picture, drawn);
    std::printf("the CPU: %.2f s, %.2f million rays a second; RMSE %.3g, of the encoded values %.3g steps of 1/255; "
                "%.0f of a million pixels differ by more than one step\n",
                exact.seconds, static_cast<double>(exact.rays) / exact.seconds / 1e6, apart.rmse, apart.rmse_steps,
                apart.differing_per_million);
    write_image(program.beside_picture("difference.png"), difference_picture(exact.picture, drawn));
}

// The mesh on its table without rays.
void rasterise(const Program &program, const GlContext &context, const Studio &on_table) {
    Rasteriser rasteriser(context.gl(), on_table);
    const auto draw = [&] {
        rasteriser.draw(on_table.view, program.width, program.height);
        context.gl().Finish();
    };
    draw(); // the driver translates the shader
    const double seconds = median_seconds({draw}, 1).front();
    std::printf("%s, rasterised in %.3f s\n", context.renderer().c_str(), seconds);
    write_image(program.beside_picture("rasterised.png"), rasteriser.picture(on_table.view));
}

} // namespace

int main(int argc, char **argv) {
    return run_program("17_gpu", "The tracer as a fragment shader", argc, argv, [](Program &program) {
        std::string context_name = "auto", scene = "whitted", mesh, walk = "stack", base = "out/gpu";
        Limits limits{.least_weight = 0x1p-12f};
        int samples = 0, stack = 0;
        bool all = false, comparing = false, measuring = false, rays = false, rasterising = false, full = false;
        program.options.choice("--scene", scene, exhibit_names(), "What to show");
        program.options.option("--mesh", mesh, "With --scene bunny: the mesh to show in its place");
        program.options.choice("--walk", walk, walk_names, "How to walk through a mesh's boxes");
        program.options.choice("--context", context_name, {"auto", "osmesa", "egl", "window"},
                               "Where OpenGL comes from: no screen, a GPU without a screen, a hidden window");
        program.options.option(
            "--samples", samples, {0, 65536},
            "Passes, each with a sample for every pixel; 0: 4, with an area light 64, in a window 256");
        program.options.option("--bounces", limits.bounces, {0, 64}, "How often a ray may bounce");
        program.options.option("--stack", stack, {0, 64}, "How many rays may wait in a pixel; 0: as many as ever do");
        program.options.flag("--everything", all, "Use a shader that holds every effect: same picture, more time");
        program.options.flag("--rasterise", rasterising,
                             "With --scene bunny: triangles and shadow maps in place of rays");
        program.options.flag("--compare", comparing, "Render on the CPU in double as well, and compare");
        program.options.flag("--measure", measuring, "Instead measure every way to draw; see --report");
        program.options.flag("--rays", rays,
                             "Instead measure rays per second, of the bunny and of a million triangles");
        program.options.option("--report", base, "With --measure: where FILE.json, FILE.md and FILE.svg go");
        program.options.flag("--full", full, "With --measure: larger pictures and meshes, more rounds");
        program.parse();

        if (measuring) {
            require_writable(base + ".json");
            write_gpu_report(context_name, mesh, base, full, program.seed);
            return;
        }
        if (rays) {
            require_writable(base + "_rays.json");
            write_ray_report(context_name, mesh, base, full, program.seed);
            return;
        }
        const auto samples_or = [&](int otherwise) { return samples > 0 ? samples : otherwise; };
        if (program.in_window()) {
            show_live(exhibit_named(scene, mesh, limits, program.seed), {walk, scene, !all, stack}, program.width,
                      program.height, samples_or(256));
            return;
        }
        const auto context = open_context(context_name);
        Exhibit exhibit = exhibit_named(scene, mesh, limits, program.seed);
        samples = samples_or(exhibit.scene.strata > 1 ? exhibit.scene.strata * exhibit.scene.strata : 4);
        if (stack > 0)
            exhibit.scene.ray_stack = stack;
        if (all)
            exhibit.scene = with_everything(std::move(exhibit.scene));
        if (rasterising)
            return rasterise(program, *context, studio_of(mesh));
        GpuTracer tracer(context->gl(), exhibit.scene, shader_defines(exhibit.scene, walk));
        keep_work_on_interrupt();
        const RenderedPicture drawn =
            gpu_picture(*context, tracer, exhibit.view, program.width, program.height, samples);
        std::printf("%s, %s\n", context->renderer().c_str(), scene.c_str());
        program.keep(drawn);
        if (comparing)
            compare(program, exhibit, drawn.picture, samples);
    });
}
