// Chapter 02: one of each primitive under a lamp beside the eye.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/02_primitives/cost.hpp"
#include "chapters/02_primitives/errata_tally.hpp"
#include "chapters/02_primitives/still_life.hpp"
#include "common/program.hpp"

#include <cstdio>

using namespace course;

namespace {

// The colour of a shape is chosen by its type: the compiler picks the overload, nothing is looked up while tracing.
Colour paint(const Plane<> &) { return {0.42f, 0.45f, 0.52f}; }
Colour paint(const Disk<> &) { return {0.85f, 0.50f, 0.13f}; }
Colour paint(const AffineTriangle<> &) { return {0.10f, 0.42f, 0.50f}; }
Colour paint(const Cylinder<> &) { return {0.85f, 0.82f, 0.74f}; }
Colour paint(const Cone<> &) { return {0.66f, 0.10f, 0.07f}; }
Colour paint(const Box<> &) { return {0.08f, 0.19f, 0.46f}; }
Colour paint(const Sphere<> &) { return {0.80f, 0.76f, 0.70f}; }
Colour paint(const Implicit<Torus<>> &) { return {0.22f, 0.45f, 0.17f}; }
Colour paint(const Implicit<LatticeBlob<>> &) { return {0.80f, 0.30f, 0.22f}; }

const Colour background(0.012f, 0.014f, 0.02f);

// There is no light before chapter 03. A surface shows as much of its colour as it faces the eye, on either side.
Colour radiance(const Ray<double> &ray, const StillLife &scene) {
    count_ray();
    const auto hit = closest_hit(ray, scene);
    if (!hit)
        return background;
    return with_hit(ray, hit, scene, [&](const auto &surface) {
        const double facing = std::abs(dot(surface.normal, normalize(ray.direction)));
        return mix(background, paint(surface.shape), static_cast<float>(facing * std::sqrt(facing)));
    });
}

void report_cost(const Program &program) {
    Report report{"Cost of each intersection test", Row().set("seed", program.seed),
                  cost_of_each_test(program.seed, 15)};
    std::fputs(terminal_table(report.results).c_str(), stdout);
    write_json(program.beside_picture("cost.json"), report);
    write_markdown(program.beside_picture("cost.md"), report);
}

} // namespace

int main(int argc, char **argv) {
    const char *summary = "Primitives: one of each, and any implicit surface";
    return run_program("02_primitives", summary, argc, argv, [](Program &program) {
        bool measure = false, errata = false;
        program.options.flag("--measure", measure, "Instead time each intersection test");
        program.options.flag("--errata", errata, "Instead count how often the notes' printed formulas are right");
        program.parse();
        if (errata)
            std::fputs(terminal_table(errata_rows()).c_str(), stdout);
        if (measure)
            report_cost(program);
        if (errata || measure)
            return;

        const StillLife scene = still_life();
        program.render(still_life_view, [&scene](const Viewpoint &from, int width, int height) {
            return each_pixel([&scene, camera = Camera(from, width, height)](int x, int y) {
                return radiance(camera.ray(x + 0.5, y + 0.5), scene);
            });
        });
    });
}
