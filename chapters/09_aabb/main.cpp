// Chapter 09: how many steps each pixel's ray takes: without a box, with one, and with a box around each of many parts.
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/09_aabb/measure.hpp"
#include "chapters/09_aabb/taught.hpp"
#include "common/program.hpp"

using namespace course;

namespace {

// The triangles by the cell of a coarse lattice that their middle lies in, with a box around those of each cell and one
// around all.
OneBox<OneBox<Triangle<>>> boxed_parts(const std::vector<Triangle<>> &all, int cells) {
    const Box<float> whole = bounds(std::span<const Triangle<>>(all));
    std::vector<std::vector<Triangle<>>> parts(static_cast<std::size_t>(cells * cells * cells));
    for (const Triangle<> &triangle : all) {
        const Vec<double> share = (centre(bounds(triangle)) - Vec<double>(whole.lo)) / extent(whole);
        int cell = 0;
        for (int axis = 0; axis < 3; ++axis) // a flat mesh divides 0 by 0: all in one layer
            cell = cell * cells + (share[axis] > 0 ? std::min(static_cast<int>(share[axis] * cells), cells - 1) : 0);
        parts[static_cast<std::size_t>(cell)].push_back(triangle);
    }
    std::vector<OneBox<Triangle<>>> boxes;
    for (const auto &part : parts)
        if (!part.empty())
            boxes.emplace_back(std::span<const Triangle<>>(part));
    return OneBox<OneBox<Triangle<>>>(boxes); // structures are shapes, so they nest
}

// A list is tested from end to end whatever is found on the way, so its steps can be counted without making them.
template <class X> double steps_without_tests(const Ray<double> &ray, const X &list) {
    Counts counts;
    CountedRay<> counted{ray, &counts};
    count_ray();
    traverse(counted, list, [&](Id) {
        counts.tests += list.shapes.slots(); // the first stands for all
        return true;
    });
    return steps_of(counts);
}

Renderer three_maps(const std::vector<Triangle<>> &all, int cells) {
    const HeatScale scale{1, 1e5};
    return [list = PlainList<Triangle<>>(all), one = OneBox<Triangle<>>(all), parts = boxed_parts(all, cells),
            scale](const Viewpoint &view, int width, int height) {
        const int third = (width + 2) / 3;
        return each_pixel([&, scale, width, height, third, camera = Camera(view, third, height)](int x, int y) {
            if (const auto drawn = legend(scale, x, y, width, height))
                return *drawn;
            const Ray<double> ray = camera.ray(x % third + 0.5, y + 0.5);
            const int panel = x / third;
            return scale(panel == 0   ? steps_without_tests(ray, list)
                         : panel == 1 ? steps_without_tests(ray, one)
                                      : steps_along(ray, parts));
        });
    };
}

} // namespace

int main(int argc, char **argv) {
    return run_program("09_aabb", "Bounding boxes: the work behind each pixel", argc, argv, [](Program &program) {
        std::string mesh, structure;
        bool measure = false;
        int cells = 8;
        program.options.option("--mesh", mesh, "The mesh to show (.obj, .off, .ply or .stl) in place of the bunny");
        program.options.option("--cells", cells, {1, 64}, "Cut the mesh into cells of so many to an edge");
        program.options.choice("--structure", structure, names_of(structures_of_09),
                               "Instead show the mesh in the studio, its hits found with this (slow: try --mesh)");
        program.options.flag("--measure", measure, "Instead measure what bounds cost and save: tables and plots");
        program.parse();

        const Studio studio = studio_of(mesh);
        if (measure) {
            measure_bounds(program, studio.mesh());
            measure_lost_rays(program);
        } else if (!structure.empty()) {
            const auto scene = exhibit_in(structures_of_09, structure, studio);
            program.render(studio.view, lit_exhibit(scene, studio, program.seed));
        } else {
            Viewpoint farther = studio.view; // a third of the width is left for each map
            farther.field_of_view = 58;
            program.render(farther, three_maps(triangles(studio.mesh()), cells));
        }
    });
}
