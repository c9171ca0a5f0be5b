#include "chapters/14_bvh/measure.hpp"

#include "chapters/09_aabb/counters.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "common/parallel.hpp"
#include "common/publish.hpp"
#include "common/timing.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace course {
namespace {

// How far down the deepest leaf is, and how many primitives a leaf holds on average.
struct Shape {
    int depth = 0;
    std::size_t leaves = 0;
};

Shape shape_of(const Tree &tree, Link at, int depth = 0) {
    if (at.is_leaf())
        return {depth, 1};
    const Shape a = shape_of(tree, tree.nodes[at.first].children[0], depth + 1);
    const Shape b = shape_of(tree, tree.nodes[at.first].children[1], depth + 1);
    return {std::max(a.depth, b.depth), a.leaves + b.leaves};
}

std::vector<Ray<double>> primary_rays(const Viewpoint &view) {
    constexpr int side = 256;
    const Camera camera(view, side, side);
    std::vector<Ray<double>> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

// From where the primary rays hit, on in a direction drawn from the cosine law.
template <class X>
std::vector<Ray<double>> bounce_rays(const std::vector<Ray<double>> &primary, const X &structure, Random random) {
    std::vector<Ray<double>> rays;
    for (const auto &ray : primary)
        if (const auto hit = closest_hit(ray, structure))
            rays.push_back(with_hit(ray, hit, structure, [&](const auto &surface) {
                const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
                const Vec<double> ball(r * std::cos(angle), r * std::sin(angle), z);
                return spawn_ray(surface, facing(surface.normal, ray.direction) + ball);
            }));
    return rays;
}

template <class X> void search_all(const std::vector<Ray<double>> &rays, const X &structure) {
    for (const auto &ray : rays)
        keep(closest_hit(ray, structure));
}

template <class X> Row row_of(const std::string &name, const std::vector<Triangle<>> &triangles,
                              const std::vector<Ray<double>> &primary, Random random) {
    const auto build = [&] { return X(std::span<const Triangle<>>(triangles)); };
    const X structure = build();
    const Shape shape = shape_of(structure.tree, structure.tree.root);
    const auto bounce = bounce_rays(primary, structure, random);
    const auto seconds = median_seconds(
        {[&] { keep(build()); }, [&] { search_all(primary, structure); }, [&] { search_all(bounce, structure); }}, 5);
    Counts counts;
    for (const auto &ray : bounce)
        closest_hit(CountedRay<>{ray, &counts}, structure);
    const auto per_bounce = [&](std::uint64_t n) {
        return static_cast<double>(n) / static_cast<double>(bounce.size());
    };
    const auto count = static_cast<double>(triangles.size());
    return Row()
        .set("rule", name)
        .set("build_ms", 1e3 * seconds[0])
        .set("deepest_leaf", shape.depth)
        .set("triangles_per_leaf", count / static_cast<double>(shape.leaves))
        .set("bytes_per_triangle", static_cast<double>(bytes(structure)) / count)
        .set("nodes_per_bounce_ray", per_bounce(counts.nodes))
        .set("tests_per_bounce_ray", per_bounce(counts.tests))
        .set("primary_mrays_per_s", 1e-6 * static_cast<double>(primary.size()) / seconds[1])
        .set("bounce_mrays_per_s", 1e-6 * static_cast<double>(bounce.size()) / seconds[2]);
}

} // namespace

void measure_rules(const Program &program, const Studio &studio) {
    const auto all = triangles(studio.mesh());
    const auto primary = primary_rays(studio.view);
    Report report{"Two rules for a bounding volume hierarchy (one ray at a time, one core)",
                  Row().set("seed", program.seed).set("triangles", size(studio.mesh())),
                  {row_of<MedianBvh<Triangle<>>>("longest axis, median", all, primary, Random(program.seed)),
                   row_of<Bvh<Triangle<>>>("binned SAH", all, primary, Random(program.seed))}};
    Plot plot{.title = "Building longer, searching faster",
              .x_label = "build, milliseconds",
              .y_label = "bounce rays, million per second",
              .series = {}};
    for (const Row &row : report.results)
        plot.series.push_back(
            {std::get<std::string>(*row.find("rule")),
             {{std::get<double>(*row.find("build_ms")), std::get<double>(*row.find("bounce_mrays_per_s"))}},
             Series::Style::points});
    publish(program, "rules", report, plot);
}

void measure_median(const Program &program) {
    Report report{"Finding the median: nth_element against sorting", Row().set("seed", program.seed), {}};
    Plot plot{.title = "The median of n numbers",
              .x_label = "n",
              .y_label = "nanoseconds for each of the n",
              .log_x = true,
              .series = {{"nth_element", {}}, {"sort", {}}}};
    for (std::size_t n = 1000; n <= 4096000; n *= 4) {
        Random random(program.seed, n);
        std::vector<double> numbers(n);
        for (double &number : numbers)
            number = random.uniform();
        const auto half = static_cast<std::ptrdiff_t>(n / 2);
        std::vector<double> work;
        const auto seconds = median_seconds({[&] { work = numbers; },
                                             [&] {
                                                 work = numbers;
                                                 std::nth_element(work.begin(), work.begin() + half, work.end());
                                             },
                                             [&] {
                                                 work = numbers;
                                                 std::sort(work.begin(), work.end());
                                             }},
                                            5);
        const auto each = [&](std::size_t i) { return 1e9 * (seconds[i] - seconds[0]) / static_cast<double>(n); };
        report.results.push_back(Row().set("n", n).set("nth_element_ns_each", each(1)).set("sort_ns_each", each(2)));
        plot.series[0].points.push_back({static_cast<double>(n), each(1)});
        plot.series[1].points.push_back({static_cast<double>(n), each(2)});
    }
    publish(program, "median", report, plot);
}

void measure_cores(const Program &program) {
    const unsigned cores = use_threads(0);
    Report report{"Building on one core and on all", Row().set("seed", program.seed).set("cores", cores), {}};
    Plot plot{.title = "Building the tree of n triangles (binned SAH)",
              .x_label = "n",
              .y_label = "nanoseconds for each of the n",
              .log_x = true,
              .series = {{"one core", {}}, {std::to_string(cores) + " cores", {}}}};
    for (std::size_t n = 4000; n <= 1'024'000; n *= 4) {
        const auto list = soup(n, program.seed);
        const auto build_on = [&](unsigned threads) {
            return [&list, threads] {
                use_threads(threads);
                keep(Bvh<Triangle<>>(std::span<const Triangle<>>(list)));
            };
        };
        const auto seconds = median_seconds({build_on(1), build_on(0)}, 3);
        report.results.push_back(Row()
                                     .set("n", n)
                                     .set("one_core_ms", 1e3 * seconds[0])
                                     .set("all_cores_ms", 1e3 * seconds[1])
                                     .set("times_as_fast", seconds[0] / seconds[1]));
        for (const std::size_t i : {0, 1})
            plot.series[i].points.push_back({static_cast<double>(n), 1e9 * seconds[i] / static_cast<double>(n)});
    }
    publish(program, "cores", report, plot);
}

} // namespace course
