// Chapter 15: the bunny in a wide BVH. The nodes behind each pixel: left in pairs of boxes, right in eights.
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/14_bvh/shown.hpp"
#include "chapters/15_wide_bvh/bounced.hpp"
#include "chapters/15_wide_bvh/by_kind.hpp"
#include "chapters/15_wide_bvh/kinds.hpp"
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

// The mesh in light that has bounced once, with so many samples squared in a pixel; sorted: the
// rays of each kind in their own way.
template <class AnyScene>
Renderer bounced(const AnyScene &scene, const Studio &studio, bool sorted, int samples, std::uint64_t seed) {
    return [&scene, &studio, sorted, samples, seed](const Viewpoint &view, int width, int height) {
        const auto colour = bounced_exhibit(studio, Camera(view, width, height), samples, seed);
        return sorted ? each_pixel_by_kind(scene, samples * samples, by_kind, colour)
                      : each_pixel_ray_by_ray(scene, samples * samples, colour);
    };
}

} // namespace

int main(int argc, char **argv) {
    return run_program("15_wide_bvh", "Wide BVH: eight boxes at once", argc, argv, [](Program &program) {
        std::string mesh, structure = "wide", show = "maps", trace = "ray-by-ray";
        bool roofline = false, kinds = false;
        int samples = 4;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_15),
                               "What finds the hits of --show lit");
        program.options.choice("--show", show, {"maps", "lit", "bounced"},
                               "The nodes behind each pixel, the lit mesh, or the mesh in light that has bounced once");
        program.options.choice("--trace", trace, {"ray-by-ray", "by-kind"}, "How --show bounced traces its rays");
        program.options.option("--samples", samples, {1, 64}, "--show bounced has so many samples squared in a pixel");
        program.options.flag("--kinds", kinds, "Instead measure which way suits which kind of rays");
        program.options.flag("--roofline", roofline, "Instead measure what the processor would allow");
        program.parse();

        const Studio studio = studio_of(mesh);
        if (roofline) {
            measure_roofline(program, studio);
        } else if (kinds) {
            measure_kinds(program, studio);
        } else if (show == "bounced") {
            const auto scene = exhibit<WideBvh>(studio);
            program.render(studio.view, bounced(scene, studio, trace == "by-kind", samples, program.seed));
        } else if (show == "maps") {
            const auto pairs = exhibit<Bvh>(studio);
            const auto eights = exhibit<WideBvh>(studio);
            program.render(studio.view, two_maps(pairs, eights));
        } else if (structure == "wide") {
            const auto scene = exhibit<WideBvh>(studio);
            program.render(studio.view, lit_exhibit(scene, studio, program.seed));
        } else
            with_shown(structure, studio, program.seed,
                       [&](const Shown &shown) { program.render(studio.view, shown.lit); });
    });
}
