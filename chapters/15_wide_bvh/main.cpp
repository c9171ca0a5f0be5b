// Chapter 15: the bunny in a wide BVH. The nodes behind each pixel: left in pairs of boxes, right in eights.
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/15_wide_bvh/roofline.hpp"
#include "chapters/15_wide_bvh/taught.hpp"
#include "common/program.hpp"

using namespace course;

namespace {

// How many nodes the ray has to wait for.
template <class AnyScene> double nodes_along(const Ray<double> &ray, const AnyScene &scene) {
    Counts counts;
    count_ray();
    closest_hit(CountedRay<>{ray, &counts}, scene);
    return static_cast<double>(counts.nodes);
}

// The map of two scenes, divided in the middle.
template <class A, class B> Renderer two_maps(const A &left, const B &right) {
    return [&left, &right](const Viewpoint &view, int width, int height) {
        return each_pixel([&left, &right, width, height, camera = Camera(view, width, height)](int x, int y) {
            const HeatScale scale{1, 100};
            if (const auto drawn = legend(scale, x, y, width, height))
                return *drawn;
            const Ray<double> ray = camera.ray(x + 0.5, y + 0.5);
            return scale(x < width / 2 ? nodes_along(ray, left) : nodes_along(ray, right));
        });
    };
}

} // namespace

int main(int argc, char **argv) {
    return run_program("15_wide_bvh", "Wide BVH: eight boxes at once", argc, argv, [](Program &program) {
        std::string mesh, structure = "wide", show = "maps";
        bool roofline = false;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_15),
                               "What finds the hits of --show lit");
        program.options.choice("--show", show, {"maps", "lit"}, "The nodes behind each pixel, or the lit mesh");
        program.options.flag("--roofline", roofline, "Instead measure what the processor would allow");
        program.parse();

        const Studio studio = studio_of(mesh);
        if (roofline) {
            measure_roofline(program, studio);
        } else if (show == "maps") {
            const auto pairs = exhibit<Bvh>(studio);
            const auto eights = exhibit<WideBvh>(studio);
            program.render(studio.view, two_maps(pairs, eights));
        } else
            with_exhibit(structures_of_15, structure, studio, [&](const auto &scene) {
                program.render(studio.view, lit_exhibit(scene, studio, program.seed));
            });
    });
}
