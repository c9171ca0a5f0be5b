// C2 to C8, C18, C20 and C21: what the notes say about acceleration structures.
#include "chapters/09_aabb/other_bounds.hpp"
#include "chapters/10_uniform_grid/grid.hpp"
#include "chapters/11_octree/octree.hpp"
#include "chapters/12_kd_tree/kd_tree.hpp"
#include "chapters/13_bsp_tree/bsp.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "chapters/16_comparison/run.hpp"
#include "common/parallel.hpp"
#include "tests/claims/claim.hpp"

#include <cmath>
#include <cstdarg>

namespace course {
namespace {

std::string said(const char *format, ...) {
    char text[600];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

TestScene scene_of(const std::string &name, const ClaimOptions &options) {
    return std::ranges::find(scene_makers(), name, &SceneMaker::name)->make(options.quick, options.seed);
}

std::vector<Ray<double>> primary_rays(const TestScene &scene, int side) {
    const Camera camera(scene.view, side, side);
    std::vector<Ray<double>> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

template <class X> double ns_per_ray(const X &structure, const std::vector<Ray<double>> &rays, int rounds) {
    const auto all = [&] {
        for (const Ray<double> &ray : rays)
            keep(closest_hit(ray, structure));
    };
    return 1e9 * median_seconds({all}, rounds)[0] / static_cast<double>(rays.size());
}

template <class X> X around(const TestScene &scene) { return X(std::span<const Triangle<>>(scene.triangles)); }

Finding cells_per_object(const ClaimOptions &options) {
    Plot plot{"Cells of a grid", "cells per triangle", "ns per primary ray", true, true, {}};
    bool always = true, ever = false;
    std::string words;
    for (const std::string name : {"soup", "bunny", "hall"}) {
        const TestScene scene = scene_of(name, options);
        const auto rays = primary_rays(scene, options.quick ? 64 : 256);
        Series series{name, {}};
        double best = infinity<double>, best_cells = 0, at_27 = 0;
        for (const double cells : {1.0, 3.0, 9.0, 27.0, 81.0, 243.0}) {
            const Grid<Triangle<>> grid(std::span<const Triangle<>>(scene.triangles), {.cells = cells});
            const double ns = ns_per_ray(grid, rays, 3);
            series.points.push_back({cells, ns});
            if (ns < best)
                best = ns, best_cells = cells;
            if (cells == 27)
                at_27 = ns;
        }
        plot.series.push_back(series);
        words += said("%s%s: 27 cells a triangle take %.2f times the time of the best, %.0f", words.empty() ? "" : "; ",
                      name.c_str(), at_27 / best, best_cells);
        const bool about_right = at_27 <= 1.25 * best;
        always &= about_right;
        ever |= about_right;
    }
    return {words, always ? Holds::yes : ever ? Holds::depends : Holds::no, plot};
}

Finding even_and_uneven(const ClaimOptions &options) {
    Plot plot{"The grid on even and uneven scenes", "1 soup, 2 bunny, 3 stadium", "ns per primary ray", false, true,
              {{"grid", {}}, {"bvh", {}}}};
    std::vector<double> ratios;
    for (const std::string name : {"soup", "bunny", "stadium"}) {
        const TestScene scene = scene_of(name, options);
        const auto rays = primary_rays(scene, name == "stadium" ? 24 : 64);
        const double grid = ns_per_ray(around<Grid<Triangle<>>>(scene), rays, 3);
        const double bvh = ns_per_ray(around<Bvh<Triangle<>>>(scene), rays, 3);
        ratios.push_back(grid / bvh);
        plot.series[0].points.push_back({static_cast<double>(ratios.size()), grid});
        plot.series[1].points.push_back({static_cast<double>(ratios.size()), bvh});
    }
    return {
        said("the grid takes %.2f times the BVH's time on the soup, %.1f times on the bunny, %.0f times on the bunny "
             "in a stadium",
             ratios[0], ratios[1], ratios[2]),
        ratios[0] < 2 && ratios[2] > 10 ? Holds::yes : Holds::depends, plot};
}

// How many entries the lists have for each shape that is in one, and the share of shapes that are in several.
struct Copies {
    double each, several;
};
Copies copies_in(std::span<const Id> entries, std::size_t shapes) {
    std::vector<int> times(shapes, 0);
    for (const Id slot : entries)
        ++times[slot];
    return {static_cast<double>(entries.size()) / static_cast<double>(shapes),
            static_cast<double>(std::ranges::count_if(times, [](int n) { return n > 1; })) /
                static_cast<double>(shapes)};
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

Finding several_leaves(const ClaimOptions &options) {
    Plot plot{"Copies in a kd-tree and in a BVH", "1 bunny, 2 soup, 3 needles", "entries per triangle", false, false,
              {{"kd-tree", {}}, {"bvh", {}}}};
    std::string words;
    for (const std::string name : {"bunny", "soup", "needles"}) {
        const TestScene scene = scene_of(name, options);
        const auto kd = around<KdTreeSah<Triangle<>>>(scene);
        const auto bvh = around<Bvh<Triangle<>>>(scene);
        const Copies copies = copies_in(kd.lists, kd.shapes.slots());
        const auto at = static_cast<double>(plot.series[0].points.size() + 1);
        plot.series[0].points.push_back({at, copies.each});
        plot.series[1].points.push_back({at, 1});
        words += said("%s%s: %.0f %% of the triangles are in several leaves, %.1f entries each; in the BVH each is in "
                      "one, but %.0f %% of its pairs of boxes overlap",
                      words.empty() ? "" : "; ", name.c_str(), 100 * copies.several, copies.each,
                      100 * share_of_overlapping(bvh.tree));
    }
    return {words, Holds::yes, plot};
}

Finding cut_in_two(const ClaimOptions &options) {
    Plot plot{"Triangles that an octree's cells cut",
              "1 bunny, 2 soup, 3 needles",
              "% in several leaves",
              false,
              false,
              {{"octree", {}}}};
    std::string words;
    for (const std::string name : {"bunny", "soup", "needles"}) {
        const auto tree = around<Octree<Triangle<>>>(scene_of(name, options));
        const Copies copies = copies_in(tree.octants.entries, tree.shapes.slots());
        plot.series[0].points.push_back({static_cast<double>(plot.series[0].points.size() + 1), 100 * copies.several});
        words += said("%s%s: %.0f %% of the triangles lie in several leaves, %.1f entries each",
                      words.empty() ? "" : "; ", name.c_str(), 100 * copies.several, copies.each);
    }
    return {words, Holds::yes, plot};
}

Finding planes_in_any_direction(const ClaimOptions &options) {
    Plot plot{"Planes of a BSP-tree that lie across no axis",
              "1 tree of branches, 2 hall, 3 rings",
              "% of the planes",
              false,
              false,
              {{"oblique", {}}}};
    std::string words;
    const std::vector<std::pair<std::string, Triangles>> models{
        {"tree", tree(4, 8, options.seed)}, {"hall", hall(3, 1)}, {"rings", rings(3, 16, 8, options.seed)}};
    for (const auto &[name, triangles] : models) {
        const Bsp<Triangle<>> bsp(triangles);
        double planes = 0, oblique = 0;
        for (const BspNode &node : bsp.planes.nodes) {
            if (node.is_leaf())
                continue;
            const Vec<float> normal = node.plane().normal;
            planes += 1;
            oblique += (normal.x != 0) + (normal.y != 0) + (normal.z != 0) > 1;
        }
        plot.series[0].points.push_back(
            {static_cast<double>(plot.series[0].points.size() + 1), 100 * oblique / planes});
        words += said("%s%s: %.0f %% of %.0f planes lie across no axis", words.empty() ? "" : "; ", name.c_str(),
                      100 * oblique / planes, planes);
    }
    const bool all = std::ranges::all_of(plot.series[0].points, [](const PlotPoint &point) { return point.y > 0; });
    return {words + "; the others are those of an axis, which the surface area heuristic finds the cheaper ones there",
            all ? Holds::yes : Holds::depends, plot};
}

Finding quickselect(const ClaimOptions &options) {
    Plot plot{"The median of n numbers",          "n", "comparisons for each of the n", true, false,
              {{"nth_element", {}}, {"sort", {}}}};
    std::vector<std::pair<double, double>> select, sort;
    double select_ns = 0, sort_ns = 0;
    for (std::size_t n = 1000; n <= (options.quick ? 512'000u : 4'096'000u); n *= 8) {
        Random random(options.seed, n);
        std::vector<double> numbers(n), work;
        for (double &number : numbers)
            number = random.uniform();
        std::size_t comparisons = 0;
        const auto less = [&](double a, double b) { return ++comparisons, a < b; };
        const auto count = static_cast<double>(n);
        const auto counted = [&](const auto &algorithm) {
            work = numbers;
            comparisons = 0;
            const double seconds = seconds_of(algorithm);
            return std::pair(static_cast<double>(comparisons), 1e9 * seconds / count);
        };
        const auto half = static_cast<std::ptrdiff_t>(n / 2);
        const auto [in_select, select_time] =
            counted([&] { std::nth_element(work.begin(), work.begin() + half, work.end(), less); });
        const auto [in_sort, sort_time] = counted([&] { std::sort(work.begin(), work.end(), less); });
        select.push_back({count, in_select}), sort.push_back({count, in_sort});
        select_ns = select_time, sort_ns = sort_time;
        plot.series[0].points.push_back({count, in_select / count});
        plot.series[1].points.push_back({count, in_sort / count});
    }
    const double power = *fitted_exponent(select);
    return {
        said("the comparisons of nth_element grow like n to the %.2f (%.1f a number at the largest n, %.0f ns), those "
             "of sorting like n to the %.2f (%.1f a number, %.0f ns)",
             power, plot.series[0].points.back().y, select_ns, *fitted_exponent(sort), plot.series[1].points.back().y,
             sort_ns),
        power < 1.05 ? Holds::yes : Holds::no, plot};
}

Finding best_in_practice(const ClaimOptions &options) {
    std::vector<Entrant> entrants = our_structures();
    std::erase_if(entrants, [](const Entrant &e) {
        return e.kernel == "plain" || e.structure == "none" || e.structure == "box";
    });
    Effort effort = options.quick ? quick_effort() : Effort{};
    effort.seed = options.seed;
    std::vector<Row> rows;
    for (const std::string &name : quick_scenes)
        for (Row &row : compare_scene(scene_of(name, options), entrants, find_entrant(entrants, "bvh"), effort))
            rows.push_back(std::move(row));
    std::map<std::string, std::pair<double, std::string>> fastest; // by scene and kind
    for (const Row &row : rows) {
        auto &best = fastest[text_of(row, "scene") + ", " + text_of(row, "rays")];
        best = std::max(best, {number_of(row, "mrays_per_s"), text_of(row, "structure")});
    }
    std::string others;
    int wins = 0;
    for (const auto &[where, best] : fastest) {
        wins += best.second == "bvh";
        if (best.second != "bvh")
            others += (others.empty() ? "; elsewhere: " : ", ") + best.second + " (" + where + ")";
    }
    return {
        said("the BVH with the surface area heuristic is the fastest of the course's scalar structures in %d of %zu "
             "cases of a scene and a kind of rays",
             wins, fastest.size()) +
            others,
        wins == static_cast<int>(fastest.size()) ? Holds::yes : Holds::depends,
        by_scene(rows, "bounce", "mrays_per_s", "Who is fastest on bounce rays", "million rays per second")};
}

Finding every_triangle(const ClaimOptions &options) {
    std::vector<Entrant> entrants = our_structures();
    std::erase_if(entrants, [](const Entrant &e) { return e.structure != "none" && e.structure != "bvh"; });
    Effort effort = quick_effort();
    effort.seed = options.seed;
    const auto rows = compare_growth(entrants, find_entrant(entrants, "bvh"), options.quick ? 5 : 6, effort);
    const auto growths = growth_of(rows, "primary");
    const auto &none = growths.front().points, &bvh = growths.back().points;
    return {said("the time of a ray grows like n to the %.2f without a structure and to the %.2f with a BVH; at %.0f "
                 "triangles a picture of 960 x 540 would take %.0f min against %.1f s",
                 *fitted_exponent(none), *fitted_exponent(bvh), none.back().first,
                 none.back().second * 960 * 540 / 60e9, bvh.back().second * 960 * 540 / 1e9),
            *fitted_exponent(none) > 0.8 ? Holds::yes : Holds::no, growth_plot(rows, "primary")};
}

Finding slabs_and_planes(const ClaimOptions &options) {
    const TestScene scene = scene_of("bunny", options);
    const Box<float> box = bounds(std::span<const Triangle<>>(scene.triangles));
    const Vec<double> a = normalize(Vec<double>(0.6, 0.7, -0.4)), b = normalize(cross(a, Vec<double>(0.3, -0.2, 0.9)));
    std::vector<Vec<float>> points;
    for (const Triangle<> &triangle : scene.triangles)
        points.insert(points.end(), {triangle.a, triangle.b, triangle.c});
    const Slabs slabs = slabs_around(points, {a, b, cross(a, b)});
    std::vector<Ray<double>> rays = primary_rays(scene, 64);
    std::vector<SlabRay> prepared;
    for (const Ray<double> &ray : rays)
        prepared.emplace_back(ray, box);
    const auto repeat = [](const auto &meets_all) {
        return [&meets_all] {
            for (int i = 0; i < 50; ++i)
                meets_all();
        };
    };
    const auto aligned = [&] {
        std::size_t met = 0;
        for (const SlabRay &ray : prepared)
            met += ray.meets(box, infinity<double>);
        keep(met);
    };
    const auto turned = [&] {
        std::size_t met = 0;
        for (const Ray<double> &ray : rays)
            met += meets(ray, slabs);
        keep(met);
    };
    const auto seconds = median_seconds({repeat(aligned), repeat(turned)}, 9);
    const double tests = 50.0 * static_cast<double>(rays.size());
    return {said("a box along the axes takes %.1f ns a test, with the ray prepared once; three slabs in any direction "
                 "take %.1f ns, %.1f times as long",
                 1e9 * seconds[0] / tests, 1e9 * seconds[1] / tests, seconds[1] / seconds[0]),
            seconds[1] > seconds[0] ? Holds::yes : Holds::no,
            Plot{"A test of a bound",
                 "1 along the axes, 2 in any direction",
                 "ns",
                 false,
                 false,
                 {{"time", {{1, 1e9 * seconds[0] / tests}, {2, 1e9 * seconds[1] / tests}}, Series::Style::points}}}};
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
             "%.0f; with the surface area heuristic it is %.0f, and rays are faster (C8): balance is not what they "
             "need",
             plot.series[0].points.back().x, plot.series[0].points.back().y, plot.series[2].points.back().y,
             plot.series[1].points.back().y),
        always ? Holds::yes : Holds::no, plot};
}

} // namespace

std::vector<Claim> structure_claims() {
    use_threads(1);
    return {
        {"C2", "27 cells for each object are about right for a uniform grid", cells_per_object},
        {"C3", "a uniform grid suits even scenes and fails on uneven ones", even_and_uneven},
        {"C4", "an object can be in several leaves of a kd-tree; in a BVH it is in one, but boxes overlap",
         several_leaves},
        {"C5", "an octree cuts objects in two", cut_in_two},
        {"C6", "a BSP-tree's planes are not axis-aligned, so its cells are no boxes", planes_in_any_direction},
        {"C7", "quickselect finds the median in a time that grows like n", quickselect},
        {"C8", "the BVH is the best choice in practice", best_in_practice},
        {"C18", "testing every triangle is too slow for large meshes", every_triangle},
        {"C20", "slabs along the axes are cheaper than general planes", slabs_and_planes},
        {"C21", "longest axis and median keep the tree balanced", balanced},
    };
}

} // namespace course
