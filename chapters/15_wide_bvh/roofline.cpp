#include "chapters/15_wide_bvh/roofline.hpp"

#include "chapters/09_aabb/counters.hpp"
#include "chapters/15_wide_bvh/in_flight.hpp"
#include "common/publish.hpp"
#include "common/timing.hpp"

#include <numeric>

namespace course {
namespace {

using Rays = std::vector<Ray<double>>;
using Mesh8 = WideBvh<Triangle<>>;

double ns_each(const std::function<void()> &work, double count) { return 1e9 * median_seconds({work}, 5)[0] / count; }

// ---- What the processor can do --------------------------------------------------------------------------------------

// A ray through a node whose every child is the node itself: each step has to wait for the one before.
double node_latency(const Slabs<Floats> &boxes, WideNode node) {
    std::ranges::fill(node.links, WideLink::node(0));
    const std::vector<WideNode> nodes{node};
    return ns_each(
        [&] {
            WideLink at = WideLink::node(0);
            for (int i = 0; i < 100'000; ++i) {
                const WideNode &here = nodes[at.first()];
                at = here.links[std::countr_zero(boxes(here, 1e30f).met() | 128)];
            }
            keep(at);
        },
        1e5);
}
double node_throughput(const Slabs<Floats> &boxes, const WideNode &node) {
    return ns_each(
        [&] {
            unsigned met = 0;
            for (int i = 0; i < 100'000; ++i) {
                keep(node);
                met += boxes(node, 1e30f).met();
            }
            keep(met);
        },
        1e5);
}
double leaf_throughput(const WideRay &ray, const TriangleLeaf &leaf) {
    return ns_each(
        [&] {
            unsigned bits = 0;
            for (int i = 0; i < 100'000; ++i) {
                keep(leaf);
                bits += candidates<WideOptions{}>(ray, leaf, 1e30f).bits;
            }
            keep(bits);
        },
        1e5);
}

// How long memory takes to answer, out of a working set of so many bytes: each place names the next, in random order.
double memory_latency(std::size_t bytes, Random &random) {
    struct alignas(64) Line {
        std::uint32_t next;
    };
    std::vector<std::uint32_t> order(bytes / sizeof(Line));
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.bits() % i]);
    std::vector<Line> lines(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        lines[order[i]].next = order[(i + 1) % order.size()];
    return ns_each(
        [&] {
            std::uint32_t at = 0;
            for (int i = 0; i < 1'000'000; ++i)
                at = lines[at].next;
            keep(at);
        },
        1e6);
}

// ---- What rays take ------------------------------------------------------------------------------------------------

struct Batch {
    std::string kind;
    Rays rays;
};
std::vector<Batch> batches_of(const Studio &studio, const Mesh8 &mesh, Random random) {
    Batch primary{"primary", {}}, bounce{"bounce", {}}, miss{"miss", {}};
    constexpr int side = 256;
    const Camera camera(studio.view, side, side);
    for (int i = 0; i < side * side; ++i) {
        const Ray<double> ray = camera.ray(i % side + 0.5, i / side + 0.5);
        primary.rays.push_back(ray);
        miss.rays.push_back({ray.origin, -ray.direction});
        if (const auto hit = closest_hit(ray, mesh))
            with_hit(ray, hit, mesh, [&](const auto &surface) {
                Vec<double> way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
                way *= dot(way, facing(surface.normal, ray.direction)) > 0 ? 1 : -1;
                bounce.rays.push_back(spawn_ray(surface, way));
            });
    }
    Batch shuffled{"shuffled", bounce.rays};
    for (std::size_t i = shuffled.rays.size(); i > 1; --i)
        std::swap(shuffled.rays[i - 1], shuffled.rays[random.bits() % i]);
    return {miss, primary, bounce, shuffled};
}

struct Steps {
    double nodes = 0, leaves = 0, triangles = 0;
};
Steps steps_of(const Rays &rays, const Mesh8 &mesh) {
    Counts counts;
    std::size_t leaves = 0;
    for (const auto &ray : rays) {
        const CountedRay<> counted{ray, &counts};
        const WideRay wide = wide_ray<WideOptions{}>(counted, mesh.tree);
        TriangleSearch<WideOptions{}, CountedRay<>> search(counted, wide, mesh.shapes);
        walk<WideOptions{}>(counted, wide, mesh.tree, [&](WideLink leaf, float &t_max) {
            ++leaves;
            search.look(leaf, t_max);
            return false;
        });
    }
    const auto count = static_cast<double>(rays.size());
    return {static_cast<double>(counts.nodes) / count, static_cast<double>(leaves) / count,
            static_cast<double>(counts.tests) / count};
}

} // namespace

void measure_roofline(const Program &program, const Studio &studio) {
    const auto all = triangles(studio.mesh());
    const Mesh8 mesh{std::span<const Triangle<>>(all)};
    if (mesh.tree.nodes.empty())
        throw InputError("--roofline", "the mesh has no triangle that could be hit");
    const std::vector<Batch> batches = batches_of(studio, mesh, Random(program.seed));
    const Ray<double> some = batches[1].rays[batches[1].rays.size() / 2];
    const WideRay wide = wide_ray<WideOptions{}>(some, mesh.tree);
    const Slabs<Floats> boxes(wide.boxes);
    const double latency = node_latency(boxes, mesh.tree.nodes[0]), node = node_throughput(boxes, mesh.tree.nodes[0]),
                 leaf = leaf_throughput(wide, mesh.shapes.leaves()[0]);
    std::printf("A node alone %.1f ns, after the one before %.1f ns; a leaf alone %.1f ns.\n", node, latency, leaf);
    Random random(program.seed);
    for (const std::size_t kib : {16, 1024, 16384})
        std::printf("Memory out of %zu KiB answers after %.1f ns.\n", kib, memory_latency(1024 * kib, random));

    Report report{"The walk against its roofline (one core, nanoseconds a ray)",
                  Row().set("seed", program.seed).set("triangles", size(mesh)).set("bytes", bytes(mesh)),
                  {}};
    Plot plot{.title = "What a ray takes, and what its steps would take",
              .x_label = "nodes a ray",
              .y_label = "nanoseconds",
              .series = {{"one ray at a time", {}},
                         {"in flight", {}},
                         {"steps, one after the other", {}},
                         {"steps, side by side", {}}}};
    for (const auto &[kind, rays] : batches) {
        if (rays.empty())
            continue;
        InFlight<double, WideOptions{}> flights(mesh);
        const auto seconds =
            median_seconds({[&] {
                                for (const auto &ray : rays)
                                    keep(closest_hit(ray, mesh));
                            },
                            [&] { flights(rays, false, [](std::size_t, const Hit<double> &hit) { keep(hit); }); }},
                           5);
        const auto ns = [&](double time) { return 1e9 * time / static_cast<double>(rays.size()); };
        const Steps steps = steps_of(rays, mesh);
        const double waiting = steps.nodes * latency + steps.leaves * leaf,
                     busy = steps.nodes * node + steps.leaves * leaf;
        report.results.push_back(Row()
                                     .set("rays", kind)
                                     .set("nodes", steps.nodes)
                                     .set("leaves", steps.leaves)
                                     .set("triangles", steps.triangles)
                                     .set("one_ns", ns(seconds[0]))
                                     .set("in_flight_ns", ns(seconds[1]))
                                     .set("latency_bound_ns", waiting)
                                     .set("throughput_bound_ns", busy));
        for (const auto &[series, y] : {std::pair{0, ns(seconds[0])}, {1, ns(seconds[1])}, {2, waiting}, {3, busy}})
            plot.series[static_cast<std::size_t>(series)].points.push_back({steps.nodes, y});
    }
    publish(program, "roofline", report, plot);
}

} // namespace course
