#include "chapters/12_kd_tree/measure.hpp"

#include "chapters/09_aabb/counters.hpp"
#include "chapters/10_uniform_grid/examples.hpp"
#include "chapters/12_kd_tree/kd_tree.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <chrono>
#include <cstdio>
#include <set>

namespace course {
namespace {

std::size_t entries(const Grid<Triangle<>> &grid) { return grid.cells.entries(); }
template <class Rule> std::size_t entries(const KdTreeBy<Triangle<>, Rule> &tree) { return tree.lists.size(); }

// How many different triangles the search for the nearest hit tests.
template <class Built> std::size_t different_tests(Ray<double> ray, const Built &built) {
    std::set<Id> tested;
    Hit<double> best;
    traverse(ray, built, [&](Id slot) {
        tested.insert(slot);
        closest_of(ray, built.shapes[slot], slot, best);
        return false;
    });
    return tested.size();
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class Built> Row measured(const char *name, const Example &example) {
    const auto begin = std::chrono::steady_clock::now();
    const Built built{std::span<const Triangle<>>(example.triangles)};
    const double build = seconds_since(begin);
    const auto rays = rays_of(example);
    const auto count = static_cast<double>(rays.size()), triangles = static_cast<double>(example.triangles.size());
    Counts counts;
    std::size_t different = 0;
    for (const Ray<double> &ray : rays) {
        closest_hit(CountedRay<>{ray, &counts}, built);
        different += different_tests(ray, built);
    }
    const auto search = [&] {
        for (const Ray<double> &ray : rays)
            keep(closest_hit(ray, built));
    };
    return Row()
        .set("scene", example.name)
        .set("structure", name)
        .set("entries per triangle", static_cast<double>(entries(built)) / triangles)
        .set("bytes per triangle", static_cast<double>(built.node_bytes()) / triangles)
        .set("build ms", 1e3 * build)
        .set("nodes per ray", static_cast<double>(counts.nodes) / count)
        .set("tests per ray", static_cast<double>(counts.tests) / count)
        .set("different", static_cast<double>(different) / count)
        .set("ns per ray", 1e9 * median_seconds({search}, 1)[0] / count);
}

} // namespace

void measure_trees(Program &program, const std::string &mesh_file) {
    Report report{"Kd-trees and the grid", Row().set("seed", static_cast<double>(program.seed)), {}};
    for (const Example &example : examples(mesh_file, program.seed)) {
        report.results.push_back(measured<Grid<Triangle<>>>("grid", example));
        report.results.push_back(measured<KdTreeMiddle<Triangle<>>>("kd-middle", example));
        report.results.push_back(measured<KdTreeMedian<Triangle<>>>("kd-median", example));
        report.results.push_back(measured<KdTreeSah<Triangle<>>>("kd-sah", example));
    }
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("trees.json"), report);
}

} // namespace course
