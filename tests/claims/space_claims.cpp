// C2 to C6: what the notes say about structures that divide space.
#include "chapters/11_octree/octree.hpp"
#include "chapters/12_kd_tree/kd_tree.hpp"
#include "chapters/13_bsp_tree/bsp.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "common/parallel.hpp"
#include "tests/claims/cases.hpp"
#include "tests/claims/scenes.hpp"

namespace course {
namespace {

Finding cells_per_object(const ClaimOptions &options) {
    Plot plot{"Cells of a grid", "cells per triangle", "ns per primary ray", true, true, {}};
    Cases cases("the scene");
    for (const std::string &name : {std::string("soup"), model_scene(options), std::string("hall")}) {
        const TestScene scene = claim_scene(name, options);
        const auto rays = primary_rays(scene, options.quick ? 48 : 256);
        const std::vector<double> cells{1, 3, 9, 27, 81, 243};
        std::vector<Grid<Triangle<>>> grids;
        for (const double each : cells)
            grids.emplace_back(std::span<const Triangle<>>(scene.triangles), CellsPerShape{.cells = each});
        std::vector<std::function<void()>> loops;
        for (const auto &grid : grids)
            loops.push_back(trace_all(rays, grid));
        const std::vector<double> seconds = median_seconds(loops, 5);
        Series series{name, {}};
        for (std::size_t i = 0; i < cells.size(); ++i)
            series.points.push_back({cells[i], 1e9 * seconds[i] / static_cast<double>(rays.size())});
        plot.series.push_back(series);
        const auto best = std::ranges::min_element(seconds) - seconds.begin();
        const double ratio = seconds[3] / seconds[static_cast<std::size_t>(best)];
        cases.add(name, ratio <= 1.25,
                  said("27 cells take %.2f times the time of the best number, %.0f", ratio,
                       cells[static_cast<std::size_t>(best)]));
    }
    return cases.finding(plot);
}

Finding even_and_uneven(const ClaimOptions &options) {
    Plot plot{"The grid on even and uneven scenes",
              "1 soup (even), 2 stadium (uneven)",
              "ns per primary ray",
              false,
              true,
              {{"grid", {}, Series::Style::points}, {"bvh", {}, Series::Style::points}}};
    Cases cases("which half of the sentence is asked");
    for (const std::string name : {"soup", "stadium"}) {
        const TestScene scene = claim_scene(name, options);
        const auto rays = primary_rays(scene, name == "soup" ? 64 : options.quick ? 16 : 24);
        const auto grid = around<Grid<Triangle<>>>(scene);
        const auto bvh = around<Bvh<Triangle<>>>(scene);
        const auto seconds = median_seconds({trace_all(rays, grid), trace_all(rays, bvh)}, 3);
        for (const std::size_t i : {0u, 1u})
            plot.series[i].points.push_back(
                {name == "soup" ? 1.0 : 2.0, 1e9 * seconds[i] / static_cast<double>(rays.size())});
        const double ratio = seconds[0] / seconds[1];
        if (name == "soup")
            cases.add("even, a soup of triangles", ratio < 2, said("the grid takes %.2f times the BVH's time", ratio));
        else
            cases.add("uneven, a model in a stadium", ratio > 10, said("%.0f times", ratio));
    }
    return cases.finding(plot);
}

// How many entries the lists have for each shape that is in one, and the share of shapes that are in several.
struct Copies {
    double each, several;
};
Copies copies_in(std::span<const Id> entries, std::size_t shapes) {
    std::vector<int> times(shapes, 0);
    for (const Id slot : entries)
        ++times[slot];
    const auto count = static_cast<double>(shapes);
    return {static_cast<double>(entries.size()) / count,
            static_cast<double>(std::ranges::count_if(times, [](int n) { return n > 1; })) / count};
}

// The share of a walk's tests that ask a ray about a triangle for the second time or more often.
template <class X> double share_of_repeated_tests(const X &structure, const std::vector<Ray<double>> &rays) {
    std::vector<std::size_t> last(structure.shapes.slots(), 0);
    double tests = 0, repeated = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        auto search = prepared<typename X::Shape>(rays[i]);
        Hit<double> best;
        traverse(search, structure, [&](Id slot) {
            tests += 1;
            repeated += std::exchange(last[slot], i + 1) == i + 1;
            closest_of(search, structure.shapes[slot], structure.shapes.first_id(slot), best);
            return false;
        });
    }
    return tests > 0 ? repeated / tests : 0;
}

double volume(const Box<float> &box) {
    const Vec<double> e = extent(box);
    return holds_any(box) ? e.x * e.y * e.z : 0;
}

// The share of a tree's nodes whose two children overlap in more than a face.
double share_of_overlapping(const Tree &tree) {
    const auto box_of_child = [](const Node &node, int child) {
        Box<float> box;
        for (int axis = 0; axis < 3; ++axis) {
            box.lo[axis] = node.planes[axis][0][child];
            box.hi[axis] = node.planes[axis][1][child];
        }
        return box;
    };
    const auto overlap = [&](const Node &node) {
        return volume(common_part(box_of_child(node, 0), box_of_child(node, 1))) > 0;
    };
    return static_cast<double>(std::ranges::count_if(tree.nodes, overlap)) / static_cast<double>(tree.nodes.size());
}

// How many slots the leaves hold together.
Id slots_in_leaves(const Tree &tree) {
    Id sum = tree.root.count;
    for (const Node &node : tree.nodes)
        sum += node.children[0].count + node.children[1].count;
    return sum;
}

// The scenes of C4 and C5, each measured by `measure` on a core of its own.
template <class Measure> auto on_each_scene(const ClaimOptions &options, const Measure &measure) {
    const std::vector<std::string> names{model_scene(options), "soup", "needles"};
    std::vector<std::pair<std::string, decltype(measure(TestScene{}))>> results(names.size());
    parallel_for(names.size(), [&](std::size_t i) {
        results[i] = {names[i], measure(claim_scene(names[i], options))};
    });
    return results;
}

Finding several_leaves(const ClaimOptions &options) {
    struct Measured {
        Copies in_kd;
        double repeated, copies_in_bvh, overlapping;
    };
    const auto results = on_each_scene(options, [&](const TestScene &scene) {
        const auto kd = around<KdTreeSah<Triangle<>>>(scene);
        const auto bvh = around<Bvh<Triangle<>>>(scene);
        return Measured{copies_in(kd.lists, kd.shapes.slots()), share_of_repeated_tests(kd, primary_rays(scene, 48)),
                        static_cast<double>(slots_in_leaves(bvh.tree)) / bvh.shapes.slots(),
                        share_of_overlapping(bvh.tree)};
    });
    Plot plot{"Copies in a kd-tree and in a BVH",
              "",
              "entries per triangle",
              false,
              false,
              {{"kd-tree", {}, Series::Style::points}, {"bvh", {}, Series::Style::points}}};
    Cases cases("the scene");
    for (const auto &[name, m] : results) {
        const auto at = static_cast<double>(plot.series[0].points.size() + 1);
        plot.x_label += said("%s%.0f %s", at > 1 ? ", " : "", at, name.c_str());
        plot.series[0].points.push_back({at, m.in_kd.each});
        plot.series[1].points.push_back({at, m.copies_in_bvh});
        cases.add(name, m.in_kd.several > 0 && m.repeated > 0 && m.copies_in_bvh == 1 && m.overlapping > 0,
                  said("%.0f %% of the triangles are in several leaves of the kd-tree, %.1f entries each, and %.0f %% "
                       "of a ray's tests are repetitions; the BVH has %.0f entry each, and %.0f %% of its pairs of "
                       "boxes overlap",
                       100 * m.in_kd.several, m.in_kd.each, 100 * m.repeated, m.copies_in_bvh, 100 * m.overlapping));
    }
    return cases.finding(plot);
}

Finding cut_in_two(const ClaimOptions &options) {
    const auto results = on_each_scene(options, [](const TestScene &scene) {
        const auto tree = around<Octree<Triangle<>>>(scene);
        return copies_in(tree.octants.entries, tree.shapes.slots());
    });
    Plot plot{"Triangles that an octree's cells cut", "", "% in several leaves", false, false,
              {{"octree", {}, Series::Style::points}}};
    Cases cases("the scene");
    for (const auto &[name, copies] : results) {
        const auto at = static_cast<double>(plot.series[0].points.size() + 1);
        plot.x_label += said("%s%.0f %s", at > 1 ? ", " : "", at, name.c_str());
        plot.series[0].points.push_back({at, 100 * copies.several});
        cases.add(name, copies.several > 0.1,
                  said("%.0f %% of the triangles lie in several leaves, %.1f entries each", 100 * copies.several,
                       copies.each));
    }
    return cases.finding(plot);
}

Finding planes_in_any_direction(const ClaimOptions &options) {
    const std::vector<std::pair<std::string, Triangles>> models{
        {"tree of branches", tree(4, 8, options.seed)}, {"hall", hall(3, 1)}, {"rings", rings(3, 16, 8, options.seed)}};
    std::vector<std::pair<double, double>> counted(models.size()); // planes, and those across no axis
    parallel_for(models.size(), [&](std::size_t i) {
        const Bsp<Triangle<>> bsp(models[i].second);
        for (const BspNode &node : bsp.planes.nodes) {
            if (node.is_leaf())
                continue;
            const Vec<float> normal = node.plane().normal;
            counted[i].first += 1;
            counted[i].second += (normal.x != 0) + (normal.y != 0) + (normal.z != 0) > 1;
        }
    });
    Plot plot{"Planes of a BSP-tree that lie across no axis",
              "1 tree of branches, 2 hall, 3 rings",
              "% of the planes",
              false,
              false,
              {{"oblique", {}, Series::Style::points}}};
    Cases cases("the scene");
    for (std::size_t i = 0; i < models.size(); ++i) {
        const double percent = 100 * counted[i].second / counted[i].first;
        plot.series[0].points.push_back({static_cast<double>(i + 1), percent});
        cases.add(models[i].first, percent > 50,
                  said("%.0f %% of %.0f planes lie across no axis", percent, counted[i].first));
    }
    return cases.finding(plot, "the others are those of an axis, which the surface area heuristic finds the cheaper "
                               "ones there");
}

} // namespace

std::vector<Claim> space_claims() {
    return {
        {"C2", "27 cells for each object are about right for a uniform grid", "10_uniform_grid",
         "the time of primary rays through grids of 1 to 243 cells a triangle, in turns",
         "27 cells take at most a quarter longer than the best number of cells", true, cells_per_object},
        {"C3", "a uniform grid suits even scenes and fails on uneven ones", "10_uniform_grid",
         "the time of primary rays through a grid and through a BVH, in turns",
         "on the even scene the grid takes less than twice the BVH's time, on the uneven one more than ten times", true,
         even_and_uneven},
        {"C4",
         "an object can be in several leaves of a kd-tree and be tested again; in a BVH it is in one, but boxes "
         "overlap",
         "12_kd_tree",
         "entries in the leaves of both trees, tests that a primary ray repeats, pairs of boxes with a "
         "volume in common",
         "the kd-tree has triangles in several leaves and repeats tests; the BVH has one entry for each, and boxes "
         "that overlap",
         false, several_leaves},
        {"C5", "an octree cuts objects in two", "11_octree", "in how many leaves each triangle is listed",
         "more than one triangle in ten lies in several leaves", false, cut_in_two},
        {"C6", "a BSP-tree's planes are not axis-aligned, so its cells are no boxes", "13_bsp_tree",
         "the planes that a tree built by the surface area heuristic has chosen",
         "more than half of the planes lie across no axis", false, planes_in_any_direction},
    };
}

} // namespace course
