#include "chapters/09_aabb/measure.hpp"

#include "chapters/09_aabb/one_box.hpp"
#include "chapters/09_aabb/other_bounds.hpp"
#include "chapters/09_aabb/slab.hpp"
#include "common/publish.hpp"
#include "common/random.hpp"
#include "common/timing.hpp"

#include <functional>
#include <string>
#include <vector>

namespace course {
namespace {

Vec<double> random_vector(Random &random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// Three directions at right angles, turned away from every axis.
std::array<Vec<double>, 3> turned_axes() {
    const Vec<double> a = normalize(Vec<double>(0.6, 0.7, -0.4)), b = normalize(cross(a, Vec<double>(0.3, -0.2, 0.9)));
    return {a, b, cross(a, b)};
}

struct Candidate {
    std::string name;
    std::function<bool(const Ray<double> &)> meets;
    std::function<std::size_t()> run; // all rays, in one tight loop
};

template <class Meets> Candidate candidate(std::string name, const std::vector<Ray<double>> &rays, const Meets &meets) {
    return {std::move(name), meets, [&rays, meets] {
                std::size_t met = 0;
                for (const auto &ray : rays)
                    met += meets(ray);
                return met;
            }};
}

// Rays through the neighbourhood of a bound: from a place two radii away to a place within one and a half.
std::vector<Ray<double>> rays_around(const Sphere<> &ball, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const double radius = static_cast<double>(ball.radius);
    std::vector<Ray<double>> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<double> origin = Vec<double>(ball.centre) + 2 * radius * normalize(random_vector(random));
        rays.push_back({origin, Vec<double>(ball.centre) + 1.5 * radius * random_vector(random) - origin});
    }
    return rays;
}

} // namespace

void measure_bounds(const Program &program, const Mesh<> &mesh) {
    const std::span<const Vec<float>> points(mesh.points);
    const Sphere<> ball = bounding_sphere(points);
    const Box<float> box = bounds(mesh);
    const Slabs slabs = slabs_around(points, turned_axes());
    const auto rays = rays_around(ball, 4096, program.seed);

    const std::vector<Candidate> candidates{
        candidate("box, as printed", rays, [&](const auto &ray) { return meets_textbook(ray, box); }),
        candidate("box, ray prepared for it alone", rays,
                  [&](const auto &ray) { return SlabRay(ray, box).meets(box, ray.t_max); }),
        candidate("box, nothing prepared", rays, [&](const auto &ray) { return meets_plainly(ray, box); }),
        candidate("slabs in any direction", rays, [&](const auto &ray) { return meets(ray, slabs); }),
        candidate("sphere", rays, [&](const auto &ray) { return meets(ray, ball); })};

    std::vector<std::function<void()>> loops;
    for (const Candidate &one : candidates)
        loops.push_back([&one] {
            for (int repeat = 0; repeat < 20; ++repeat)
                keep(one.run());
        });
    // What a structure pays: one ray is prepared once and meets many boxes.
    std::vector<SlabRay> prepared;
    for (const auto &ray : rays)
        prepared.emplace_back(ray, box);
    loops.push_back([&] {
        for (int repeat = 0; repeat < 20; ++repeat) {
            std::size_t met = 0;
            for (const SlabRay &ray : prepared)
                met += ray.meets(box, infinity<double>);
            keep(met);
        }
    });
    const auto seconds = median_seconds(loops, 9);

    const double tests = 20.0 * static_cast<double>(rays.size()), share = 100 / static_cast<double>(rays.size());
    const double printed = seconds[0];
    Report report{"Bounds of the mesh: cost of a test, and how many rays come through",
                  Row().set("seed", program.seed).set("triangles", size(mesh)),
                  {}};
    const auto add = [&](const std::string &name, double time, std::size_t met) {
        report.results.push_back(Row()
                                     .set("bound", name)
                                     .set("ns_per_test", 1e9 * time / tests)
                                     .set("time_against_box_as_printed", time / printed)
                                     .set("rays_let_through_percent", share * static_cast<double>(met)));
    };
    for (std::size_t i = 0; i < candidates.size(); ++i)
        add(candidates[i].name, seconds[i], candidates[i].run());
    add("box, ray prepared for many", seconds.back(), candidates[1].run());

    Plot plot{.title = "What a bound costs, and what it lets through",
              .x_label = "nanoseconds a test",
              .y_label = "rays let through, percent",
              .series = {}};
    for (const Row &row : report.results)
        plot.series.push_back(
            {std::get<std::string>(*row.find("bound")),
             {{std::get<double>(*row.find("ns_per_test")), std::get<double>(*row.find("rays_let_through_percent"))}},
             Series::Style::points});
    publish(program, "bounds", report, plot);
}

namespace {

// A ray and a box on a lattice of small whole numbers: the ray passes exactly through a point of the box.
struct Case {
    Ray<double> ray;
    Box<float> box;
};

using Family = std::function<Case(Random &)>;

Vec<double> lattice_point(Random &random) {
    return {std::floor(random.uniform(-8, 9)), std::floor(random.uniform(-8, 9)), std::floor(random.uniform(-8, 9))};
}

Box<float> lattice_box(Random &random) {
    const Vec<double> a = lattice_point(random), b = lattice_point(random);
    return {Vec<float>(min(a, b)), Vec<float>(max(a, b) + Vec<double>(1))};
}

// From afar, exactly through the point; steps are whole, so t = 2 there.
Ray<double> through(const Vec<double> &point, Vec<double> step) {
    if (step == Vec<double>(0))
        step.x = 1;
    return {point - 2.0 * step, step};
}

std::vector<std::pair<std::string, Family>> families() {
    const auto corner = [](Random &random, const Box<float> &box) {
        Vec<double> p(box.lo);
        for (int axis = 0; axis < 3; ++axis)
            if (random.bits() % 2)
                p[axis] = static_cast<double>(box.hi[axis]);
        return p;
    };
    return {{"through the middle",
             [](Random &random) {
                 const Box<float> box = lattice_box(random);
                 return Case{through(centre(box), lattice_point(random)), box};
             }},
            {"flat box",
             [](Random &random) {
                 Box<float> box = lattice_box(random);
                 const int axis = static_cast<int>(random.bits() % 3);
                 box.hi[axis] = box.lo[axis];
                 Vec<double> step = lattice_point(random);
                 step[axis] = 1;
                 return Case{through(centre(box), step), box};
             }},
            {"in the plane of a face",
             [](Random &random) {
                 const Box<float> box = lattice_box(random);
                 const int axis = static_cast<int>(random.bits() % 3);
                 Vec<double> point = centre(box), step = lattice_point(random);
                 point[axis] = static_cast<double>(random.bits() % 2 ? box.lo[axis] : box.hi[axis]);
                 step[axis] = random.bits() % 2 ? 0.0 : -0.0;
                 return Case{through(point, step), box};
             }},
            {"through a corner",
             [corner](Random &random) {
                 const Box<float> box = lattice_box(random);
                 return Case{through(corner(random, box), lattice_point(random)), box};
             }},
            {"along an edge", [corner](Random &random) {
                 const Box<float> box = lattice_box(random);
                 Vec<double> step(0);
                 step[static_cast<int>(random.bits() % 3)] = random.bits() % 2 ? 1 : -1;
                 return Case{through(corner(random, box), step), box};
             }}};
}

} // namespace

void measure_lost_rays(const Program &program) {
    constexpr int cases = 200000;
    Report report{"Rays that meet a box exactly, and are lost, per million",
                  Row().set("seed", program.seed).set("cases", cases),
                  {}};
    Plot plot{.title = "Rays that a slab test loses", .x_label = "family", .y_label = "lost per million", .series = {}};
    Series printed{"as printed", {}, Series::Style::points}, robust{"robust", {}, Series::Style::points};
    for (const auto &[name, family] : families()) {
        Random random(program.seed);
        double lost_printed = 0, lost_robust = 0;
        for (int i = 0; i < cases; ++i) {
            const Case one = family(random);
            lost_printed += !meets_textbook(one.ray, one.box);
            lost_robust += !SlabRay(one.ray, one.box).meets(one.box, infinity<double>);
        }
        report.results.push_back(Row()
                                     .set("rays", name)
                                     .set("as_printed", 1e6 * lost_printed / cases)
                                     .set("robust", 1e6 * lost_robust / cases));
        const double place = static_cast<double>(report.results.size());
        printed.points.push_back({place, 1e6 * lost_printed / cases, name});
        robust.points.push_back({place, 1e6 * lost_robust / cases});
    }
    plot.series = {printed, robust};
    publish(program, "lost_rays", report, plot);
}

} // namespace course
