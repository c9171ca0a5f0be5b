// C7, C8, C18, C20 and C21: what the notes say about bounding volumes and their hierarchies.
#include "chapters/09_aabb/other_bounds.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "chapters/16_comparison/compare.hpp"
#include "chapters/16_comparison/plots.hpp"
#include "tests/claims/cases.hpp"
#include "tests/claims/scenes.hpp"

#include <cmath>

namespace course {
namespace {

Finding quickselect(const ClaimOptions &options) {
    Plot plot{"The median of n numbers",          "n", "comparisons for each of the n", true, false,
              {{"nth_element", {}}, {"sort", {}}}};
    std::vector<std::pair<double, double>> selecting, sorting; // n, and the comparisons
    for (std::size_t n = 1000; n <= (options.quick ? 512'000u : 4'096'000u); n *= 8) {
        Random random(options.seed, n);
        std::vector<double> numbers(n);
        for (double &number : numbers)
            number = random.uniform();
        const auto count = static_cast<double>(n);
        const auto comparisons_of = [&](const auto &algorithm) {
            std::vector<double> work = numbers;
            double comparisons = 0;
            algorithm(work, [&](double a, double b) { return ++comparisons, a < b; });
            return std::pair(count, comparisons);
        };
        selecting.push_back(comparisons_of([&](auto &list, const auto &less) {
            std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(n / 2), list.end(), less);
        }));
        sorting.push_back(
            comparisons_of([](auto &list, const auto &less) { std::sort(list.begin(), list.end(), less); }));
        plot.series[0].points.push_back({count, selecting.back().second / count});
        plot.series[1].points.push_back({count, sorting.back().second / count});
    }
    const double power = *fitted_exponent(selecting);
    return {said("the comparisons of nth_element grow like n to the %.2f (%.1f a number at the largest n), those of "
                 "sorting like n to the %.2f (%.1f a number)",
                 power, plot.series[0].points.back().y, *fitted_exponent(sorting), plot.series[1].points.back().y),
            power < 1.05 ? Holds::yes : Holds::no,
            {},
            plot};
}

// The course's own structures but for some, each with its default triangle.
std::vector<Entrant> structures_without(const std::vector<std::string> &left_out) {
    std::vector<Entrant> entrants = our_structures();
    std::erase_if(entrants, [&](const Entrant &e) {
        return e.kernel == "plain" || std::ranges::find(left_out, e.structure) != left_out.end();
    });
    return entrants;
}

Effort effort_of(const ClaimOptions &options) {
    Effort effort = options.quick ? quick_effort() : Effort{};
    effort.seed = options.seed;
    return effort;
}

Finding best_in_practice(const ClaimOptions &options) {
    // The wide BVH is a BVH as well, but one with eight lanes where the others have one.
    const std::vector<Entrant> entrants = structures_without({"none", "box", "wide"});
    Effort effort = effort_of(options);
    if (options.quick) // small scenes, so that not even the slowest build takes a second
        effort.side = 96, effort.seconds = 0.01, effort.builds = 1;
    std::vector<Row> rows;
    for (const std::string &name : {model_scene(options), std::string("soup"), std::string("needles"),
                                    std::string("hall"), std::string("stadium")})
        for (Row &row : compare_scene(claim_scene(name, options), entrants, find_entrant(entrants, "bvh"), effort))
            rows.push_back(std::move(row));

    std::map<std::string, std::map<std::string, double>> speeds; // by scene and kind of rays, then by structure
    for (const Row &row : rows)
        speeds[text_of(row, "scene") + " " + text_of(row, "rays")][text_of(row, "structure")] =
            number_of(row, "mrays_per_s");
    Cases cases("the scene and the rays");
    std::map<std::string, double> log_ratios;
    double worst = 1;
    for (const auto &[where, speed] : speeds) {
        const auto best = std::ranges::max_element(speed, {}, [](const auto &one) { return one.second; });
        const double bvh = speed.at("bvh");
        cases.add(bvh >= best->second / 1.1 ? where : where + " (" + best->first + ")", bvh >= best->second / 1.1);
        worst = std::max(worst, best->second / bvh);
        for (const auto &[structure, value] : speed)
            log_ratios[structure] += std::log(value / bvh) / static_cast<double>(speeds.size());
    }
    log_ratios.erase("bvh");
    const auto next = std::ranges::max_element(log_ratios, {}, [](const auto &one) { return one.second; });
    return cases.finding(
        by_scene(rows, "bounce", "mrays_per_s", "Who is fastest on bounce rays", "million rays per second"),
        said("of %zu cases, a scene and a kind of rays, the BVH with the surface area heuristic is the fastest or "
             "within a tenth of it in %zu, and at worst %.1f times slower; the next best on the geometric mean, %s, "
             "has %.2f times its speed",
             cases.asked(), cases.held(), worst, next->first.c_str(), std::exp(next->second)));
}

Finding every_triangle(const ClaimOptions &options) {
    std::vector<Entrant> entrants = structures_without({});
    std::erase_if(entrants, [](const Entrant &e) { return e.structure != "none" && e.structure != "bvh"; });
    Effort effort = quick_effort();
    effort.seed = options.seed;
    const auto rows = compare_growth(entrants, find_entrant(entrants, "bvh"), options.quick ? 4 : 6, effort);
    const auto growths = growth_of(rows, "primary");
    const auto &none = growths.front().points, &bvh = growths.back().points;
    const double power = *fitted_exponent(none), minutes = none.back().second * 960 * 540 / 60e9;
    return {said("the time of a ray grows like n to the %.2f without a structure and to the %.2f with a BVH; at %.0f "
                 "triangles a picture of 960 x 540 would take %.1f min against %.1f s",
                 power, *fitted_exponent(bvh), none.back().first, minutes, bvh.back().second * 960 * 540 / 1e9),
            power > 0.8 && minutes > 1 ? Holds::yes : Holds::no,
            {},
            growth_plot(rows, "primary")};
}

Finding slabs_and_planes(const ClaimOptions &options) {
    const TestScene scene = claim_scene(model_scene(options), options);
    const Box<float> box = bounds(std::span<const Triangle<>>(scene.triangles));
    const Vec<double> a = normalize(Vec<double>(0.6, 0.7, -0.4)), b = normalize(cross(a, Vec<double>(0.3, -0.2, 0.9)));
    std::vector<Vec<float>> points;
    for (const Triangle<> &triangle : scene.triangles)
        points.insert(points.end(), {triangle.a, triangle.b, triangle.c});
    const Slabs slabs = slabs_around(points, {a, b, cross(a, b)});
    const std::vector<Ray<double>> rays = primary_rays(scene, 64);
    std::vector<SlabRay> ready;
    for (const Ray<double> &ray : rays)
        ready.emplace_back(ray, box);
    const auto loop = [](const auto &list, const auto &meets_it) {
        return [&] {
            std::size_t met = 0;
            for (int i = 0; i < 50; ++i)
                for (const auto &ray : list)
                    met += meets_it(ray);
            keep(met);
        };
    };
    const auto aligned = [&](const SlabRay &ray) { return ray.meets(box, infinity<double>); };
    const auto turned = [&](const Ray<double> &ray) { return meets(ray, slabs); };
    const auto seconds = median_seconds({loop(ready, aligned), loop(rays, turned)}, 9);
    const double tests = 50.0 * static_cast<double>(rays.size()), ns = 1e9 / tests;
    const double ratio = seconds[1] / seconds[0];
    return {said("a box along the axes takes %.1f ns a test, with the ray prepared once; three slabs in any direction "
                 "take %.1f ns, %.1f times as long",
                 ns * seconds[0], ns * seconds[1], ratio),
            ratio > 1.05 ? Holds::yes : Holds::no,
            {},
            Plot{"A test of a bound",
                 "1 along the axes, 2 in any direction",
                 "ns",
                 false,
                 false,
                 {{"time", {{1, ns * seconds[0]}, {2, ns * seconds[1]}}, Series::Style::points}}}};
}

int depth_of(const Tree &tree, Link at) {
    if (at.is_leaf())
        return 0;
    const auto &children = tree.nodes[at.first].children;
    return 1 + std::max(depth_of(tree, children[0]), depth_of(tree, children[1]));
}

Finding balanced(const ClaimOptions &options) {
    Plot plot{"The deepest leaf",
              "triangles",
              "levels below the root",
              true,
              false,
              {{"median", {}}, {"SAH", {}}, {"least possible", {}}}};
    bool always = true;
    for (int cells = 23; cells <= (options.quick ? 184 : 736); cells *= 2) {
        const auto triangles = terrain(cells, options.seed);
        const std::span<const Triangle<>> list(triangles);
        const auto count = static_cast<double>(triangles.size());
        const MedianBvh<Triangle<>> median(list);
        const Bvh<Triangle<>> sah(list);
        const double least = std::ceil(std::log2(count / LongestAxisMedian{}.largest_leaf));
        plot.series[0].points.push_back({count, static_cast<double>(depth_of(median.tree, median.tree.root))});
        plot.series[1].points.push_back({count, static_cast<double>(depth_of(sah.tree, sah.tree.root))});
        plot.series[2].points.push_back({count, least});
        always &= plot.series[0].points.back().y <= least;
    }
    return {
        said("with the median the deepest of %.0f triangles is %.0f levels down, and no tree can do with fewer than "
             "%.0f; with the surface area heuristic, which does not care for balance, it is %.0f",
             plot.series[0].points.back().x, plot.series[0].points.back().y, plot.series[2].points.back().y,
             plot.series[1].points.back().y),
        always ? Holds::yes : Holds::no,
        {},
        plot};
}

} // namespace

std::vector<Claim> tree_claims() {
    return {
        {"C7", "quickselect finds the median in a time that grows like n", "14_bvh",
         "the comparisons that finding the median of n random numbers takes", "they grow like n to a power below 1.05",
         false, quickselect},
        {"C8", "the BVH is the best choice in practice", "16_comparison",
         "rays of four kinds through every structure of the course but the wide one, in turns, each answer verified",
         "no structure is more than a tenth faster", true, best_in_practice},
        {"C18", "testing every triangle is too slow for large meshes", "08_mesh",
         "the time of a ray against the number of triangles, without a structure and with a BVH",
         "without one the time grows like n to a power above 0.8, and a picture takes more than a minute", true,
         every_triangle},
        {"C20", "slabs along the axes are cheaper than general planes", "09_aabb",
         "the time of both tests for the same rays, in turns", "the general planes take over 5 % longer", true,
         slabs_and_planes},
        {"C21", "longest axis and median keep the tree balanced", "14_bvh",
         "the deepest leaf of trees over ever finer hills", "no tree with leaves as large could be less deep", false,
         balanced},
    };
}

} // namespace course
