#include "chapters/08_mesh/measure.hpp"

#include "chapters/08_mesh/losses.hpp"
#include "common/plot.hpp"
#include "common/report.hpp"

#include <chrono>
#include <cstdio>

namespace course {
namespace {

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
        for (const Family &family : families) {
            const Losses losses = losses_of(family, prepare_ray, prepare_triangle, test);
            row.set("leaks_" + family.name, losses.leaks).set("even_" + family.name, losses.even);
        }
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
