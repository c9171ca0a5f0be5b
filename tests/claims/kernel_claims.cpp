// C9, C10, C11 and C17: what the notes say about the tests of a triangle, and about Fresnel's equations.
#include "chapters/07_glass/measurements.hpp"
#include "chapters/08_mesh/inside.hpp"
#include "chapters/08_mesh/losses.hpp"
#include "chapters/14_bvh/bvh.hpp"
#include "chapters/16_comparison/plain_triangle.hpp"
#include "common/parallel.hpp"
#include "tests/claims/cases.hpp"
#include "tests/claims/scenes.hpp"

namespace course {
namespace {

// ---- C9 and C10 ----------------------------------------------------------------------------------------------------

// Note A's triangle where structures ask for the default test: in float, as Möller–Trumbore's is in PlainTriangle.
struct PlainAffine : AffineTriangle<> {};
std::optional<float> intersect(const Ray<float> &ray, const PlainAffine &triangle) {
    return intersect_textbook(ray, static_cast<const AffineTriangle<> &>(triangle));
}
Box<float> bounds(const PlainAffine &triangle) {
    return rounded_outward<float>(bounds(static_cast<const AffineTriangle<> &>(triangle)));
}

// With nothing stored but the corners: the plane first, then the affine coordinates, all in float.
std::optional<float> plane_first(const Ray<float> &ray, const Triangle<> &triangle) {
    const Vec<float> e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, normal = cross(e1, e2);
    const float t = dot(normal, triangle.a - ray.origin) / dot(normal, ray.direction);
    if (!in_range(ray, t))
        return {};
    const Vec<float> d = point_at(ray, t) - triangle.a;
    const float area_squared = dot(normal, normal), u = dot(cross(e2, normal), d), v = dot(cross(normal, e1), d);
    if (!(u >= 0 && v >= 0 && u + v <= area_squared))
        return {};
    return t;
}

// The three ways to test a triangle in float, in turns.
struct Ways {
    double stored, moller_trumbore, plane_first; // ns a test
};

Ways time_ways(const Pairs &pairs) {
    constexpr int repeats = 20;
    const auto as_it_is = [](const auto &x) { return x; };
    const auto affine = [](const Triangle<> &t) { return affine_triangle(t.a, t.b, t.c); };
    const auto seconds =
        median_seconds({loop_over(pairs, repeats, as_it_is, affine,
                                  [](const auto &r, const auto &t) { return intersect_textbook(r, t); }),
                        loop_over(pairs, repeats, as_it_is, as_it_is,
                                  [](const auto &r, const auto &t) { return moller_trumbore(r, t); }),
                        loop_over(pairs, repeats, as_it_is, as_it_is, plane_first)},
                       11);
    const double ns = 1e9 / repeats / static_cast<double>(pairs.rays.size());
    return {ns * seconds[0], ns * seconds[1], ns * seconds[2]};
}

// The pairs of which half are hits, and pairs of a ray with another one's triangle: mostly misses.
struct BothKinds {
    Ways half, few;
};
BothKinds time_both_kinds(const ClaimOptions &options) {
    Pairs pairs = random_pairs(options.seed, 8192);
    const Ways half = time_ways(pairs);
    std::ranges::rotate(pairs.triangles, pairs.triangles.begin() + 1);
    return {half, time_ways(pairs)};
}

Plot plot_of_ways(const BothKinds &times) {
    return {
        "The triangle test in float",
        "1 half are hits, 2 few are hits",
        "ns a test",
        false,
        false,
        {{"k1, k2 stored", {{1, times.half.stored}, {2, times.few.stored}}, Series::Style::points},
         {"Möller-Trumbore", {{1, times.half.moller_trumbore}, {2, times.few.moller_trumbore}}, Series::Style::points},
         {"plane made anew", {{1, times.half.plane_first}, {2, times.few.plane_first}}, Series::Style::points}}};
}

// The time of Möller–Trumbore's rays through a BVH as a multiple of those with k1 and k2.
double ratio_in_a_tree(const ClaimOptions &options) {
    const TestScene scene = claim_scene(model_scene(options), options);
    std::vector<PlainTriangle<>> corners;
    std::vector<PlainAffine> stored;
    for (const Triangle<> &triangle : scene.triangles) {
        corners.push_back({triangle});
        stored.push_back({affine_triangle(triangle.a, triangle.b, triangle.c)});
    }
    const Bvh<PlainTriangle<>> of_corners{std::span<const PlainTriangle<>>(corners)};
    const Bvh<PlainAffine> of_stored{std::span<const PlainAffine>(stored)};
    std::vector<Ray<float>> rays;
    for (const Ray<double> &ray : primary_rays(scene, 128))
        rays.push_back({Vec<float>(ray.origin), Vec<float>(ray.direction)});
    const auto seconds = median_seconds({trace_all(rays, of_stored), trace_all(rays, of_corners)}, 9);
    return seconds[1] / seconds[0];
}

Finding stored_constants(const ClaimOptions &options) {
    const BothKinds times = time_both_kinds(options);
    Cases cases("how the test is used");
    const auto add = [&](const std::string &name, const Ways &ways) {
        cases.add(name, ways.moller_trumbore > 1.1 * ways.stored,
                  said("%.1f ns with k1 and k2 stored, %.1f ns by Möller-Trumbore", ways.stored, ways.moller_trumbore));
    };
    add("a loop in which half are hits", times.half);
    add("a loop in which few are hits", times.few);
    const double in_tree = ratio_in_a_tree(options);
    cases.add("rays through a BVH", in_tree > 1.1,
              said("with Möller-Trumbore they take %.2f times as long as with k1 and k2", in_tree));
    return cases.finding(plot_of_ways(times), said("the price is %zu bytes a triangle in place of %zu",
                                                   sizeof(AffineTriangle<>), sizeof(Triangle<>)));
}

Finding without_a_plane(const ClaimOptions &options) {
    const BothKinds times = time_both_kinds(options);
    Cases cases("how many of the rays hit");
    const auto add = [&](const std::string &name, const Ways &ways) {
        cases.add(name, ways.plane_first > 1.1 * ways.moller_trumbore && ways.moller_trumbore < 2 * ways.stored,
                  said("%.1f ns, against %.1f ns when each test makes the plane anew and %.1f ns when it is stored",
                       ways.moller_trumbore, ways.plane_first, ways.stored));
    };
    add("half are hits", times.half);
    add("few are hits", times.few);
    return cases.finding(plot_of_ways(times));
}

// ---- C11 -----------------------------------------------------------------------------------------------------------

Finding fresnel_at_zero(const ClaimOptions &) {
    Plot plot{"Reflectance near normal incidence, air to glass",
              "angle to the normal (radians)",
              "relative error",
              true,
              true,
              {}};
    Cases cases("the form");
    for (const auto &[column, name] :
         std::initializer_list<std::pair<std::string, std::string>>{{"sines, float", "sines and tangents in float"},
                                                                    {"eq. 50, float", "eq. 50 in float"},
                                                                    {"eq. 50, double", "eq. 50 in double"}}) {
        Series series{name, {}};
        double worst = 0;
        for (int digits = 1; digits <= 8; ++digits) {
            const double off = std::pow(10.0, -digits);
            series.points.push_back({off, number(reflectance_row("", off, off, 1, 1.5f), column)});
            worst = std::max(worst, series.points.back().y);
        }
        const double at_zero = number(reflectance_row("", 0, 0, 1, 1.5f), column);
        plot.series.push_back(series);
        cases.add(name, !(std::max(worst, at_zero) < 1e-5 && std::isfinite(at_zero)),
                  said("the relative error is %.1e at most down to 1e-8, and %s", worst,
                       std::isfinite(at_zero) ? said("%.1e at 0", at_zero).c_str() : "0 divided by 0 at 0"));
    }
    return cases.finding(plot);
}

// ---- C17 -----------------------------------------------------------------------------------------------------------

// Points well inside (a ball of 0.6 around `centre`), asked with rays in any direction: how many of a million are told
// to be outside.
double told_outside(const Mesh<> &mesh, const Vec<double> &centre, int points, std::uint64_t seed) {
    std::vector<unsigned char> inside(static_cast<std::size_t>(points));
    parallel_for(inside.size(), [&](std::size_t i) {
        Random random(seed, i);
        const Vec<double> from = centre + in_ball(random, 0.6);
        inside[i] = is_inside(mesh, from, in_ball(random, 1));
    });
    return 1e6 * static_cast<double>(std::ranges::count(inside, 0)) / points;
}

Finding odd_is_inside(const ClaimOptions &options) {
    const int points = options.quick ? 2'000 : 40'000;
    const std::vector<Family> families = leak_families(options.seed, points);
    Plot plot{"Points inside that are told to be outside",
              "1 faces, 2 edges, 3 corners, 4 lattice",
              "per million",
              false,
              true,
              {}};
    Cases cases("the triangle test, and on the mesh being closed and free of overlaps");
    for_each_form([&](const char *name, const char *short_name, const char *scalar, auto prepare_ray,
                      auto prepare_triangle, auto test) {
        std::vector<double> even(families.size());
        parallel_for(families.size(), [&](std::size_t i) {
            even[i] = losses_of(families[i], prepare_ray, prepare_triangle, test).even;
        });
        Series series{short_name, {}, Series::Style::points};
        for (std::size_t i = 0; i < even.size(); ++i)
            series.points.push_back({static_cast<double>(i + 1), even[i]});
        plot.series.push_back(series);
        cases.add(said("%s (%s)", name, scalar), std::ranges::max(even) == 0,
                  said("at most %.0f of a million wrong", std::ranges::max(even)));
    });

    Mesh<> open = ball(2), twice = ball(2);
    open.indices.erase(open.indices.begin(), open.indices.begin() + 8);
    const auto first = static_cast<std::uint32_t>(twice.points.size());
    const Mesh<> other = ball(2);
    for (const Vec<float> &point : other.points)
        twice.points.push_back(point + Vec<float>(0.3f, 0.2f, 0.1f));
    for (const auto &[a, b, c] : other.indices)
        twice.indices.push_back({a + first, b + first, c + first});
    for (const auto &[name, mesh] : {std::pair("watertight, a ball with a hole", open),
                                     std::pair("watertight, where two balls of one mesh overlap", twice)}) {
        const Vec<double> centre =
            mesh.points.size() > other.points.size() ? Vec<double>(0.15, 0.1, 0.05) : Vec<double>(0);
        const double wrong = told_outside(mesh, centre, points, options.seed);
        cases.add(name, wrong == 0, said("%.0f of a million wrong", wrong));
    }
    return cases.finding(plot);
}

} // namespace

std::vector<Claim> kernel_claims() {
    return {
        {"C9", "precomputing k1 and k2 makes the triangle test cheap", "08_mesh",
         "the same rays and triangles in float, with k1 and k2 stored and by Möller-Trumbore from the corners, in "
         "turns",
         "Möller-Trumbore takes over a tenth longer", true, stored_constants},
        {"C10", "Möller-Trumbore is fast without a precomputed plane", "08_mesh",
         "the same rays and triangles in float by Möller-Trumbore, with the plane made anew in each test, and with "
         "everything stored, in turns",
         "making the plane anew takes over a tenth longer, and Möller-Trumbore less than twice the time of what is "
         "stored",
         true, without_a_plane},
        {"C11", "near normal incidence Fresnel's equations are numerically inexact, so their limit is needed",
         "07_glass", "the relative error of the reflectance at angles from 0.1 down to 1e-8, and at 0",
         "it exceeds 1e-5 somewhere, or is no number", false, fresnel_at_zero},
        {"C17", "an odd number of hits means inside", "08_mesh",
         "rays from inside closed meshes, aimed at faces, edges, corners and along a lattice, by every form of the "
         "test; and from inside two meshes that are not simply closed",
         "not one is told to be outside", false, odd_is_inside},
    };
}

} // namespace course
