// Chapter 13: the bunny in a BSP-tree. Each pixel shows how many nodes its ray looked at and how many triangles it
// tested.
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/12_kd_tree/shown.hpp"
#include "chapters/13_bsp_tree/measure.hpp"
#include "chapters/13_bsp_tree/taught.hpp"
#include "common/program.hpp"

using namespace course;

int main(int argc, char **argv) {
    return run_program("13_bsp_tree", "BSP-tree: planes in any position", argc, argv, [](Program &program) {
        std::string mesh, structure = "bsp", planes = "general";
        bool plates = false, measure = false;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_13), "What finds the nearest hit");
        program.options.choice("--planes", planes, {"axis-aligned", "general", "supporting"},
                               "Which planes the BSP-tree may choose");
        program.options.flag("--plates", plates, "Show a stack of tilted plates in place of the mesh");
        program.options.flag("--measure", measure, "Instead measure the choice of planes");
        program.parse();
        if (measure)
            return measure_bsp(program, mesh);

        const std::vector<Triangle<>> triangles = plates ? tilted_plates() : model(mesh);
        const Viewpoint view = seen_whole(box_around(triangles));
        const auto show = [&](const Renderer &map) { program.render(view, map); };
        const Planes chosen = planes == "general"        ? Planes::general
                              : planes == "axis-aligned" ? Planes::axis_aligned
                                                         : Planes::supporting;
        if (structure == "bsp") {
            const Scene scene(std::vector{Bsp<Triangle<>>(triangles, {.planes = chosen})});
            show(heat_map(scene, HeatScale{}));
        } else
            with_heat_map(structure, triangles, show);
    });
}
