// Chapter 14: the bunny in a bounding volume hierarchy. Left as the light shows it, right the steps behind each pixel.
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/14_bvh/measure.hpp"
#include "chapters/14_bvh/shown.hpp"
#include "chapters/14_bvh/taught.hpp"
#include "common/program.hpp"

using namespace course;

namespace {

// One picture left of the middle, the other right of it.
Renderer side_by_side(Renderer left, Renderer right) {
    return [left = std::move(left), right = std::move(right)](const Viewpoint &view, int width, int height) {
        return [a = left(view, width, height), b = right(view, width, height), middle = width / 2](const Tile &tile,
                                                                                                   Picture &picture) {
            if (tile.x0 < middle)
                a({tile.x0, tile.y0, std::min(tile.x1, middle), tile.y1}, picture);
            if (tile.x1 > middle)
                b({std::max(tile.x0, middle), tile.y0, tile.x1, tile.y1}, picture);
        };
    };
}

} // namespace

int main(int argc, char **argv) {
    return run_program("14_bvh", "Bounding volume hierarchy: the bunny in a second", argc, argv, [](Program &program) {
        std::string mesh, structure = "bvh", show = "both";
        bool measure = false;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_14), "What finds the nearest hit");
        program.options.choice("--show", show, {"both", "lit", "map"},
                               "The lit mesh, the map of steps, or half of each");
        program.options.flag("--measure", measure, "Instead measure the rules of building, the median and the cores");
        program.parse();

        const Studio studio = studio_of(mesh);
        if (measure) {
            measure_rules(program, studio);
            measure_median(program);
            measure_cores(program);
            return;
        }
        with_shown(structure, studio, program.seed, [&](const Shown &shown) {
            const Renderer lit = shown.lit, map = shown.map(show == "both" ? 0.5 : 0);
            program.render(studio.view, show == "lit" ? lit : show == "map" ? map : side_by_side(lit, map));
        });
    });
}
