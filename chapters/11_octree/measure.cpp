#include "chapters/11_octree/measure.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/09_aabb/counters.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/11_octree/octree.hpp"
#include "common/plot.hpp"
#include "common/report.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace course {
namespace {

struct Example {
    std::string name;
    std::vector<Triangle<>> triangles;
    Viewpoint view;
};

std::vector<Ray<double>> rays_of(const Viewpoint &view) {
    const Camera camera(view, 128, 96);
    std::vector<Ray<double>> rays;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 128; ++x)
            rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

// What the leaves offer to a ray, and how much of it for the first time.
struct Offers {
    std::size_t all = 0, first = 0;
};

Offers offers_along(const std::vector<Ray<double>> &rays, const Octree<Triangle<>> &tree) {
    Offers offers;
    std::vector<std::size_t> last_ray(tree.shapes.slots(), 0); // that a slot was offered to, counted from 1
    std::size_t number = 0;
    for (Ray<double> ray : rays) {
        ++number;
        Hit<double> best;
        walk(ray, tree, [&](Id slot) {
            ++offers.all;
            if (std::exchange(last_ray[slot], number) != number) {
                ++offers.first;
                closest_of(ray, tree.shapes[slot], tree.shapes.first_id(slot), best);
            }
            return false;
        });
    }
    return offers;
}

// The share of the shapes that are in more than one leaf.
double share_of_cut(const Octree<Triangle<>> &tree) {
    std::vector<std::size_t> leaves(tree.shapes.slots(), 0);
    for (const Id slot : tree.octants.entries)
        ++leaves[slot];
    return static_cast<double>(std::ranges::count_if(leaves, [](std::size_t n) { return n > 1; })) /
           static_cast<double>(leaves.size());
}

// The row's further values: what the tree is made of, and what a ray meets in it.
Row measured(Row row, const Example &example, const OctreeRule &rule) {
    const Octree<Triangle<>> tree(std::span<const Triangle<>>(example.triangles), rule);
    const auto shapes = static_cast<double>(example.triangles.size());
    const auto rays = rays_of(example.view);
    Counts counts;
    for (const Ray<double> &ray : rays)
        closest_hit(CountedRay<>{ray, &counts}, tree);
    const Offers offers = offers_along(rays, tree);
    const auto per_ray = [&](auto number) { return static_cast<double>(number) / static_cast<double>(rays.size()); };
    return row.set("nodes", tree.octants.nodes.size())
        .set("entries per triangle", static_cast<double>(tree.octants.entries.size()) / shapes)
        .set("cut triangles %", 100 * share_of_cut(tree))
        .set("bytes per triangle", static_cast<double>(tree.node_bytes()) / shapes)
        .set("nodes per ray", per_ray(counts.nodes))
        .set("entries met per ray", per_ray(offers.all))
        .set("different ones", per_ray(offers.first))
        .set("tests per ray", per_ray(counts.tests));
}

} // namespace

void measure_octree(Program &program, const std::string &mesh_file) {
    const auto bunny = model(mesh_file);
    const std::string name = mesh_file.empty() ? "bunny" : "mesh";
    const Viewpoint view = seen_whole(box_around(bunny));
    const auto number = [](const Row &row, const char *key) { return std::get<double>(*row.find(key)); };

    Report depths{"Depth of an octree", Row().set("mesh", name), {}};
    Plot plot{"Work in an octree", "levels below the root, at most", "per ray", false, true, {}};
    plot.series = {{"nodes", {}}, {"tests", {}}};
    for (int levels = 2; levels <= 12; ++levels) {
        depths.results.push_back(measured(Row().set("levels", levels), {name, bunny, view}, {.deepest = levels}));
        const Row &row = depths.results.back();
        plot.series[0].points.push_back({static_cast<double>(levels), number(row, "nodes per ray")});
        plot.series[1].points.push_back({static_cast<double>(levels), number(row, "tests per ray")});
    }
    std::printf("%s\n", terminal_table(depths.results).c_str());
    write_json(program.beside_picture("depth.json"), depths);
    write_plot(program.beside_picture("depth.svg"), plot);

    Report cuts{"Objects that an octree cuts", Row().set("seed", static_cast<double>(program.seed)), {}};
    const auto even = soup(bunny.size(), program.seed);
    for (const Example &example : {Example{"soup", even, seen_whole(box_around(even))}, Example{name, bunny, view},
                                   Example{name + " in a stadium", in_stadium(bunny), view}})
        for (const bool exact : {false, true})
            cuts.results.push_back(measured(Row().set("scene", example.name).set("asked", exact ? "shape" : "its box"),
                                            example, {.exact = exact}));
    std::printf("%s\n", terminal_table(cuts.results).c_str());
    write_json(program.beside_picture("cuts.json"), cuts);
}

} // namespace course
