#include "chapters/10_uniform_grid/measure.hpp"

#include "chapters/09_aabb/counters.hpp"
#include "chapters/10_uniform_grid/examples.hpp"
#include "chapters/10_uniform_grid/grid.hpp"
#include "common/plot.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <cstdio>

namespace course {
namespace {

Row measured(const Example &example, double cells_per_shape) {
    const std::span<const Triangle<>> list(example.triangles);
    const auto rays = rays_of(example);
    const auto count = static_cast<double>(rays.size());
    const Grid<Triangle<>> grid(list, {.cells = cells_per_shape});
    const double build = median_seconds({[&] { keep(Grid<Triangle<>>(list, {.cells = cells_per_shape})); }}, 1)[0];
    Counts counts;
    for (const Ray<double> &ray : rays)
        closest_hit(CountedRay<>{ray, &counts}, grid);
    const double seconds = median_seconds({[&] {
                                              for (const Ray<double> &ray : rays)
                                                  keep(closest_hit(ray, grid));
                                          }},
                                          1)[0];
    return Row()
        .set("scene", example.name)
        .set("cells per triangle", cells_per_shape)
        .set("cells", grid.lattice.cells())
        .set("occupied %", 100 * static_cast<double>(grid.cells.occupied()) / grid.lattice.cells())
        .set("entries per triangle", static_cast<double>(grid.cells.entries()) / static_cast<double>(list.size()))
        .set("bytes per triangle", static_cast<double>(grid.node_bytes()) / static_cast<double>(list.size()))
        .set("build ms", 1e3 * build)
        .set("cells per ray", static_cast<double>(counts.nodes) / count)
        .set("tests per ray", static_cast<double>(counts.tests) / count)
        .set("ns per ray", 1e9 * seconds / count);
}

} // namespace

void measure_cells(Program &program, const std::string &mesh_file) {
    Report report{"Cells of a uniform grid", Row().set("seed", static_cast<double>(program.seed)), {}};
    Plot work{"Work of a uniform grid", "cells per triangle", "cells and tests per ray", true, true, {}};
    Plot time{"Time of a uniform grid", "cells per triangle", "ns per ray", true, true, {}};
    const auto number = [](const Row &row, const char *name) { return std::get<double>(*row.find(name)); };
    for (const Example &example : examples(mesh_file, program.seed)) {
        Series cells{example.name + ": cells", {}}, tests{example.name + ": tests", {}}, ns{example.name, {}};
        for (const double k : {0.3, 1.0, 3.0, 9.0, 27.0, 81.0, 243.0}) {
            const Row row = measured(example, k);
            report.results.push_back(row);
            cells.points.push_back({k, number(row, "cells per ray")});
            tests.points.push_back({k, number(row, "tests per ray")});
            ns.points.push_back({k, number(row, "ns per ray")});
        }
        work.series.insert(work.series.end(), {cells, tests});
        time.series.push_back(ns);
    }
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("cells.json"), report);
    write_plot(program.beside_picture("cells.svg"), work);
    write_plot(program.beside_picture("time.svg"), time);
}

} // namespace course
