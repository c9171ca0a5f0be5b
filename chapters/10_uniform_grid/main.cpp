// Chapter 10: the bunny in a uniform grid. Each pixel shows how many cells its ray walked through and what it tested.
#include "chapters/09_aabb/any_structure.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/10_uniform_grid/measure.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/10_uniform_grid/taught.hpp"
#include "common/program.hpp"

using namespace course;

int main(int argc, char **argv) {
    return run_program("10_uniform_grid", "Uniform grid: cell by cell along the ray", argc, argv, [](Program &program) {
        std::string mesh, structure = "grid";
        double cells = CellsPerShape{}.cells;
        bool stadium = false, measure = false;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_10), "What finds the nearest hit");
        program.options.option("--cells", cells, {1e-6, 1e4}, "Cells of the grid for each triangle");
        program.options.flag("--stadium", stadium, "Put the mesh into a stadium");
        program.options.flag("--measure", measure, "Instead measure the work against the number of cells");
        program.parse();
        if (measure)
            return measure_cells(program, mesh);

        std::vector<Triangle<>> triangles = model(mesh);
        const Viewpoint view = seen_whole(box_around(triangles));
        if (stadium)
            triangles = in_stadium(std::move(triangles));
        const AnyStructure chosen = structure == "grid" ? AnyStructure(Grid<Triangle<>>(triangles, {.cells = cells}))
                                                        : any_structure(structures_of_10, structure, triangles);
        const Scene scene(std::vector{chosen});
        program.render(view, heat_map(scene, HeatScale{}));
    });
}
