#include "chapters/08_mesh/measure.hpp"

#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/08_mesh/ball.hpp"
#include "chapters/08_mesh/inside.hpp"
#include "chapters/08_mesh/moller_trumbore.hpp"
#include "common/plot.hpp"
#include "common/random.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

namespace course {
namespace {

// A ray whose numbers are floats, so that every form is asked about the very same ray.
Ray<float> ray_through(const Vec<double> &from, const Vec<double> &to) {
    const Vec<float> origin(from);
    return {origin, Vec<float>(to - Vec<double>(origin))};
}
Ray<double> widened(const Ray<float> &ray) { return {Vec<double>(ray.origin), Vec<double>(ray.direction)}; }

Vec<double> in_ball(Random &random, double radius) {
    while (true) {
        const Vec<double> p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (dot(p, p) < 1)
            return radius * p;
    }
}

// Calls visit(name, name in a plot, scalar, prepare_ray, prepare_triangle, test) for every form.
template <class Visit> void for_each_form(Visit visit) {
    const auto as_it_is = [](const auto &x) { return x; };
    const auto sheared = [](const Ray<float> &ray) { return with_shear(widened(ray)); };
    const auto affine = [](const Triangle<> &t) { return affine_triangle(t.a, t.b, t.c); };
    const auto textbook = [](const auto &r, const auto &t) { return intersect_textbook(r, t); };
    const auto strict = [](const auto &r, const auto &t) { return moller_trumbore_strict(r, t); };
    const auto inclusive = [](const auto &r, const auto &t) { return moller_trumbore(r, t); };
    const auto standard = [](const auto &r, const auto &t) { return intersect(r, t); };
    visit("affine, k1 k2 stored (note A)", "affine, float", "float", as_it_is, affine, textbook);
    visit("affine, k1 k2 stored", "affine, double", "double inside", widened, affine, standard);
    visit("Möller-Trumbore, strict (notes B, C)", "strict, float", "float", as_it_is, as_it_is, strict);
    visit("Möller-Trumbore, with edges", "edges, float", "float", as_it_is, as_it_is, inclusive);
    visit("Möller-Trumbore, with edges", "edges, double", "double", widened, as_it_is, inclusive);
    visit("watertight", "watertight", "double inside", widened, as_it_is, standard);
    visit("watertight, shear made once a ray", "prepared", "double inside", sheared, as_it_is, standard);
}

// A ray and a triangle each: about half are hits, in no order that a processor could learn.
struct Pairs {
    std::vector<Ray<float>> rays;
    std::vector<Triangle<>> triangles;
};
Pairs random_pairs(std::uint64_t seed, std::size_t count) {
    Random random(seed);
    Pairs pairs;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle<> t{Vec<float>(in_ball(random, 1)), Vec<float>(in_ball(random, 1)),
                           Vec<float>(in_ball(random, 1))};
        const Vec<double> a(t.a), b(t.b), c(t.c);
        const double u = random.uniform(), v = random.uniform(); // half of the parallelogram a, b, a + b - c, c
        pairs.rays.push_back(ray_through(in_ball(random, 3), a + u * (b - a) + v * (c - a)));
        pairs.triangles.push_back(t);
    }
    return pairs;
}

std::vector<double> nanoseconds_per_test(std::uint64_t seed) {
    constexpr std::size_t count = 8192, repeats = 20;
    const Pairs pairs = random_pairs(seed, count);
    std::vector<std::function<void()>> variants;
    for_each_form([&](const char *, const char *, const char *, auto prepare_ray, auto prepare_triangle, auto test) {
        std::vector<decltype(prepare_ray(pairs.rays[0]))> rays;
        std::vector<decltype(prepare_triangle(pairs.triangles[0]))> triangles;
        std::ranges::transform(pairs.rays, std::back_inserter(rays), prepare_ray);
        std::ranges::transform(pairs.triangles, std::back_inserter(triangles), prepare_triangle);
        variants.push_back([rays = std::move(rays), triangles = std::move(triangles), test] {
            double sum = 0;
            for (std::size_t repeat = 0; repeat < repeats; ++repeat)
                for (std::size_t i = 0; i < count; ++i)
                    if (const auto t = test(rays[i], triangles[i]))
                        sum += static_cast<double>(*t);
            keep(sum);
        });
    });
    std::vector<double> times = median_seconds(variants, 15);
    for (double &time : times)
        time *= 1e9 / (count * repeats);
    return times;
}

// Rays from inside a closed mesh, of which each must meet an odd number of triangles.
struct Family {
    std::string name;
    Mesh<> mesh;
    std::vector<Ray<float>> rays;
};

std::vector<Family> leak_families(std::uint64_t seed) {
    constexpr int count = 40000;
    Random random(seed);
    std::vector<Family> families{
        {"face", ball(2), {}}, {"edge", ball(2), {}}, {"corner", ball(2), {}}, {"lattice", ball(2, 8), {}}};
    for (int i = 0; i < count; ++i) {
        const Triangle<> t = triangle(families[0].mesh, random.bits() % size(families[0].mesh));
        const Vec<double> a(t.a), b(t.b), c(t.c), from = in_ball(random, 0.7);
        const double u = random.uniform(), v = (1 - u) * random.uniform();
        families[0].rays.push_back(ray_through(from, a + u * (b - a) + v * (c - a)));
        families[1].rays.push_back(ray_through(from, a + u * (b - a)));
        families[2].rays.push_back(ray_through(from, a));
    }
    // Corners on whole numbers, and rays along the axes from halves and wholes: edges are hit exactly, again and again.
    for (Vec<float> &point : families[3].mesh.points)
        point = round(point);
    for (int i = 0; i < count; ++i) {
        Ray<float> ray{Vec<float>(round(in_ball(random, 8))) * 0.5f, Vec<float>(0)};
        ray.direction[static_cast<int>(random.bits() % 3)] = random.bits() % 2 ? 1.0f : -1.0f;
        families[3].rays.push_back(ray);
    }
    return families;
}

template <class PrepareRay, class PrepareTriangle, class Test>
void count_losses(const Family &family, PrepareRay prepare_ray, PrepareTriangle prepare_triangle, Test test, Row &row) {
    std::vector<decltype(prepare_triangle(triangle(family.mesh, 0)))> prepared;
    for (Id id = 0; id < size(family.mesh); ++id)
        prepared.push_back(prepare_triangle(triangle(family.mesh, id)));
    std::uint64_t leaks = 0, even = 0;
    for (const Ray<float> &plain : family.rays) {
        const auto ray = prepare_ray(plain);
        const auto hits = std::ranges::count_if(prepared, [&](const auto &t) { return test(ray, t).has_value(); });
        leaks += hits == 0;
        even += hits % 2 == 0;
    }
    const double million = 1e6 / static_cast<double>(family.rays.size());
    row.set("leaks_" + family.name, million * static_cast<double>(leaks));
    row.set("even_" + family.name, million * static_cast<double>(even));
}

double number(const Row &row, const std::string &name) { return std::get<double>(*row.find(name)); }

void write_report(const Program &program, const std::string &name, const Report &report, const Plot &plot) {
    std::printf("%s\n%s\n", report.title.c_str(), terminal_table(report.results).c_str());
    write_json(program.beside_picture(name + ".json"), report);
    write_markdown(program.beside_picture(name + ".md"), report);
    write_plot(program.beside_picture(name + ".svg"), plot);
}

} // namespace

void measure_forms(const Program &program) {
    Report report{"The triangle test in its forms: ns a test; of a million rays from inside, how many meet no triangle "
                  "(leaks) or an even number of them (even), by what they were aimed at",
                  Row().set("seed", program.seed),
                  {}};
    const std::vector<double> times = nanoseconds_per_test(program.seed);
    const std::vector<Family> families = leak_families(program.seed);
    Plot plot{"Speed and loss of the triangle tests",
              "nanoseconds a test",
              "even counts per million rays at edges",
              false,
              true,
              {}};
    for_each_form([&](const char *name, const char *short_name, const char *scalar, auto prepare_ray,
                      auto prepare_triangle, auto test) {
        Row row;
        row.set("form", name).set("scalar", scalar).set("ns_per_test", times[report.results.size()]);
        for (const Family &family : families)
            count_losses(family, prepare_ray, prepare_triangle, test, row);
        plot.series.push_back(
            {short_name, {{number(row, "ns_per_test"), number(row, "even_edge")}}, Series::Style::points});
        report.results.push_back(row);
    });
    write_report(program, "forms", report, plot);
}

void measure_cost(const Program &program) {
    using Clock = std::chrono::steady_clock;
    Report report{
        "Brute force: what one ray costs, against the number of triangles", Row().set("seed", program.seed), {}};
    Series measured{"measured", {}, Series::Style::line_and_points};
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int level = 0; level <= 6; ++level) {
        const Mesh<> mesh = ball(level);
        Random random(program.seed);
        const int rays = std::max(8, static_cast<int>(3'000'000 / size(mesh)));
        std::vector<double> rounds;
        for (int round = 0; round < 5; ++round) {
            const auto start = Clock::now();
            for (int i = 0; i < rays; ++i) {
                const Vec<double> from = in_ball(random, 3);
                keep(closest_hit(Ray<double>{from, in_ball(random, 1) - from}, mesh));
            }
            rounds.push_back(std::chrono::duration<double>(Clock::now() - start).count() / rays);
        }
        std::ranges::nth_element(rounds, rounds.begin() + 2);
        const double microseconds = 1e6 * rounds[2], x = std::log(size(mesh)), y = std::log(microseconds);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
        measured.points.push_back({static_cast<double>(size(mesh)), microseconds});
        report.results.push_back(Row()
                                     .set("triangles", size(mesh))
                                     .set("us_per_ray", microseconds)
                                     .set("ns_per_triangle", 1e3 * microseconds / size(mesh)));
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    report.options.set("slope", slope);
    std::printf("The time grows as the number of triangles to the power %.2f.\n", slope);
    Series line{"slope 1", {}, Series::Style::line};
    for (const PlotPoint &point : {measured.points.front(), measured.points.back()})
        line.points.push_back({point.x, measured.points.back().y * point.x / measured.points.back().x});
    char title[96];
    std::snprintf(title, sizeof title, "Brute force: slope %.2f", slope);
    write_report(program, "cost", report, {title, "triangles", "microseconds a ray", true, true, {measured, line}});
}

} // namespace course
