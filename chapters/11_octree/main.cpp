// Chapter 11: the bunny in an octree. Each pixel shows how many nodes its ray looked at and how many triangles it
// tested.
#include "chapters/09_aabb/any_structure.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/11_octree/measure.hpp"
#include "chapters/11_octree/taught.hpp"
#include "common/program.hpp"

using namespace course;

int main(int argc, char **argv) {
    return run_program("11_octree", "Octree: halving space where something is", argc, argv, [](Program &program) {
        std::string mesh, structure = "octree";
        int levels = OctreeRule{}.deepest;
        bool stadium = false, measure = false;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.choice("--structure", structure, names_of(structures_of_11), "What finds the nearest hit");
        program.options.option("--levels", levels, {0, 31}, "How often the octree halves space, at most");
        program.options.flag("--stadium", stadium, "Put the mesh into a stadium");
        program.options.flag("--measure", measure, "Instead measure depth, duplicates and memory");
        program.parse();
        if (measure)
            return measure_octree(program, mesh);

        std::vector<Triangle<>> triangles = model(mesh);
        const Viewpoint view = seen_whole(box_around(triangles));
        if (stadium)
            triangles = in_stadium(std::move(triangles));
        const AnyStructure chosen = structure == "octree"
                                        ? AnyStructure(Octree<Triangle<>>(triangles, {.deepest = levels}))
                                        : any_structure(structures_of_11, structure, triangles);
        const Scene scene(std::vector{chosen});
        program.render(view, heat_map(scene, HeatScale{}));
    });
}
