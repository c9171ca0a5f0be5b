#include "chapters/13_bsp_tree/measure.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/08_mesh/ball.hpp"
#include "chapters/09_aabb/counters.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/13_bsp_tree/bsp.hpp"
#include "common/plot.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <cstdio>

namespace course {

std::vector<Triangle<>> tilted_plates() {
    const Vec<double> u = normalize(Vec<double>(0.8, 0.5, 0.2)), v = normalize(cross(u, Vec<double>(0.3, -0.4, 1)));
    const Vec<double> up = cross(v, u);
    constexpr int plates = 24, side = 16;
    std::vector<Triangle<>> list;
    for (int plate = 0; plate < plates; ++plate)
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j) {
                const auto at = [&](int x, int y) -> Vec<float> {
                    return (2.0 * x / side - 1) * u + (2.0 * y / side - 1) * v + (2.0 * plate / plates - 1) * up;
                };
                list.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                list.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
    return list;
}

namespace {

struct Example {
    std::string name;
    std::vector<Triangle<>> triangles;
};

struct Kind {
    const char *name;
    Planes planes;
};
constexpr Kind kinds[] = {
    {"axis-aligned", Planes::axis_aligned}, {"general", Planes::general}, {"any triangle's", Planes::supporting}};

// The share of the planes that are not at right angles to an axis.
double share_of_slanted(const std::vector<BspNode> &nodes) {
    double inner = 0, slanted = 0;
    for (const BspNode &node : nodes) {
        const Vec<float> n = node.plane().normal;
        inner += !node.is_leaf();
        slanted += (n.x != 0) + (n.y != 0) + (n.z != 0) > 1;
    }
    return slanted / std::max(inner, 1.0);
}

Row measured(const Example &example, const Kind &kind) {
    const std::span<const Triangle<>> list(example.triangles);
    const BspRule rule{.planes = kind.planes};
    const Camera camera(seen_whole(box_around(example.triangles)), 128, 96);
    std::vector<Ray<double>> rays;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 128; ++x)
            rays.push_back(camera.ray(x + 0.5, y + 0.5));
    const Bsp<Triangle<>> tree(list, rule);
    const double build = median_seconds({[&] { keep(Bsp<Triangle<>>(list, rule)); }}, 1)[0];
    Counts counts;
    for (const Ray<double> &ray : rays)
        closest_hit(CountedRay<>{ray, &counts}, tree);
    const double seconds = median_seconds({[&] {
                                              for (const Ray<double> &ray : rays)
                                                  keep(closest_hit(ray, tree));
                                          }},
                                          3)[0];
    const auto shapes = static_cast<double>(list.size()), all = static_cast<double>(rays.size());
    return Row()
        .set("scene", example.name)
        .set("planes", kind.name)
        .set("build s", build)
        .set("nodes", tree.planes.nodes.size())
        .set("slanted %", 100 * share_of_slanted(tree.planes.nodes))
        .set("depth", tree.planes.depth)
        .set("entries per triangle", static_cast<double>(tree.planes.entries.size()) / shapes)
        .set("bytes per triangle", static_cast<double>(tree.node_bytes()) / shapes)
        .set("nodes per ray", static_cast<double>(counts.nodes) / all)
        .set("tests per ray", static_cast<double>(counts.tests) / all)
        .set("ns per ray", 1e9 * seconds / all);
}

// The classical tree without any limit: no score, no depth, no bound on entries.
Row auto_partition(const Example &example) {
    const std::span<const Triangle<>> list(example.triangles);
    const BspRule rule{Planes::supporting, 1, 0, 1e9, 1 << 20};
    const auto boxes = float_boxes(list);
    const auto tree = BspBuilder<Triangle<>>(list, rule).build(boxes, can_be_hit(boxes), box_around(example.triangles));
    return Row()
        .set("scene", example.name)
        .set("triangles", list.size())
        .set("pieces", tree.entries.size())
        .set("pieces per triangle", static_cast<double>(tree.entries.size()) / static_cast<double>(list.size()))
        .set("depth", tree.depth);
}

} // namespace

void measure_bsp(Program &program, const std::string &mesh_file) {
    const auto bunny = model(mesh_file);
    const std::string name = mesh_file.empty() ? "bunny" : "mesh";
    Report planes{"Planes of a BSP-tree", Row().set("seed", program.seed), {}};
    for (const Example &example :
         {Example{"soup", soup(20000, program.seed)}, Example{"tilted plates", tilted_plates()}, Example{name, bunny}})
        for (const Kind &kind : kinds)
            planes.results.push_back(measured(example, kind));
    std::printf("%s\n", terminal_table(planes.results).c_str());
    write_json(program.beside_picture("planes.json"), planes);

    Report classical{"Auto-partition", Row().set("seed", program.seed), {}};
    Plot plot{"The classical BSP-tree degenerates", "triangles", "", true, true, {}};
    plot.series = {{"ball: depth", {}}, {"soup: depth", {}}, {"ball: pieces", {}}, {"soup: pieces", {}}};
    for (int level = 1; level <= 4; ++level) {
        const auto convex = triangles(ball(level));
        const Example examples[] = {{"ball", convex}, {"soup", soup(convex.size(), program.seed)}};
        for (const std::size_t i : {0u, 1u}) {
            classical.results.push_back(auto_partition(examples[i]));
            const auto number = [&](const char *key) {
                return static_cast<double>(std::get<std::int64_t>(*classical.results.back().find(key)));
            };
            const auto count = static_cast<double>(convex.size());
            plot.series[i].points.push_back({count, number("depth")});
            plot.series[i + 2].points.push_back({count, number("pieces")});
        }
    }
    std::printf("%s\n", terminal_table(classical.results).c_str());
    write_json(program.beside_picture("classical.json"), classical);
    write_plot(program.beside_picture("classical.svg"), plot);
}

} // namespace course
