// Chapter 12: the bunny in a kd-tree. Each pixel shows how many nodes its ray visited and what it tested.
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/12_kd_tree/measure.hpp"
#include "chapters/12_kd_tree/shown.hpp"
#include "chapters/12_kd_tree/taught.hpp"
#include "common/program.hpp"

using namespace course;

int main(int argc, char **argv) {
    return run_program("12_kd_tree", "Kd-tree: planes where they pay", argc, argv, [](Program &program) {
        std::string mesh, structure = "kd-sah";
        bool stadium = false, measure = false;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_12), "What finds the nearest hit");
        program.options.flag("--stadium", stadium, "Put the mesh into a stadium");
        program.options.flag("--measure", measure, "Instead measure the rules of cutting beside the grid");
        program.parse();
        if (measure)
            return measure_trees(program, mesh);

        std::vector<Triangle<>> triangles = model(mesh);
        const Viewpoint view = seen_whole(box_around(triangles));
        if (stadium)
            triangles = in_stadium(std::move(triangles));
        with_heat_map(structure, triangles, [&](const Renderer &map) { program.render(view, map); });
    });
}
