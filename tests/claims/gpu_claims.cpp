// C15 and C16: what the notes say about shaders, and about rasterisation.
#include "chapters/17_gpu/measure.hpp"
#include "tests/claims/cases.hpp"

namespace course {
namespace {

struct Size {
    int width, height, rounds;
};
Size size_of(const ClaimOptions &options) { return options.quick ? Size{128, 72, 3} : Size{480, 270, 7}; }

// Where a claim needs OpenGL and there is none, the row says so and decides nothing.
using Measurement = Finding (*)(const NamedContext &, const ClaimOptions &);
Finding with_opengl(Measurement measure, const ClaimOptions &options) {
    try {
        return measure(named_context("auto"), options);
    } catch (const InputError &error) {
        return {std::string("not measured: ") + error.what(), Holds::depends, "whether there is OpenGL"};
    }
}

std::string counted(std::size_t triangles) { return std::to_string(triangles) + " triangles"; }

// ---- C15 -----------------------------------------------------------------------------------------------------------

Finding fragment_against_compute(const NamedContext &on, const ClaimOptions &options) {
    const auto [width, height, rounds] = size_of(options);
    Plot plot{"Fragment against compute: " + on.context->renderer(),
              "1 Whitted, 2 mirrors, 3 and 4 balls",
              "compute's time / fragment's",
              false,
              false,
              {{"measured", {}, Series::Style::points}}};
    Cases cases("the scene");
    std::vector<Sitter> sitters;
    for (const std::string name : {"whitted", "mirrors"})
        sitters.push_back({name, 0, exhibit_named(name, "", Limits{.least_weight = 0x1p-10f}, options.seed)});
    for (const int level : {4, options.quick ? 5 : 7})
        sitters.push_back(ball_sitter(level));
    for (const Sitter &sitter : sitters) {
        // Round by round, so that a slow spell of the machine falls on both; a few rounds that it spoils decide
        // nothing.
        const auto found = measure_ways(*on.context, sitter, {{"fragment"}, {"compute"}}, width, height, 4 * rounds);
        std::vector<double> ratios;
        for (std::size_t i = 0; i < found[0].rounds.size(); ++i)
            ratios.push_back(found[1].rounds[i] / found[0].rounds[i]);
        const double ratio = quantile(ratios, 0.5), least = quantile(ratios, 0.25), most = quantile(ratios, 0.75);
        cases.add(sitter.triangles ? counted(sitter.triangles) : sitter.name, least >= 2.08,
                  said("%.1f against %.1f ms, %.2f times as long (half of %zu rounds: %.2f to %.2f)",
                       1e3 * found[0].seconds, 1e3 * found[1].seconds, ratio, ratios.size(), least, most));
        plot.series[0].points.push_back({static_cast<double>(plot.series[0].points.size() + 1), ratio, sitter.name});
    }
    return cases.finding(plot, "by " + on.context->renderer());
}

// ---- C16 -----------------------------------------------------------------------------------------------------------

Finding rasterised_against_traced(const NamedContext &on, const ClaimOptions &options) {
    const auto [width, height, rounds] = size_of(options);
    Plot plot{"Balls on a table, with shadows: " + on.context->renderer(),  "triangles", "ms for a picture", true, true,
              {{"ray tracing", {}}, {"rasterisation with shadow maps", {}}}};
    Cases cases("the number of triangles");
    for (int level = 2; level <= (options.quick ? 6 : 8); level += 2) {
        const Sitter sitter = mesh_sitter("ball", studio(ball(level)));
        const auto found = measure_ways(*on.context, sitter, {{"fragment"}, {"raster"}}, width, height, rounds);
        const Measured &traced = found[0], &raster = found[1];
        const bool holds = raster.seconds < 0.5 * traced.seconds &&
                           traced.apart.differing_per_million < 0.5 * raster.apart.differing_per_million;
        cases.add(counted(sitter.triangles), holds,
                  said("%.1f ms against %.1f ms, %.0f and %.0f of a million pixels wrong", 1e3 * raster.seconds,
                       1e3 * traced.seconds, raster.apart.differing_per_million, traced.apart.differing_per_million));
        for (std::size_t i = 0; i < 2; ++i)
            plot.series[i].points.push_back({static_cast<double>(sitter.triangles), 1e3 * found[i].seconds});
    }
    return cases.finding(plot, "by " + on.context->renderer());
}

} // namespace

std::vector<Claim> gpu_claims() {
    return {
        {"C15", "moving from a compute shader to a fragment shader gained 160 %", "17_gpu",
         "Chapter 17's tracer as a fragment and as a compute shader, the same text, in turns: a picture of four scenes",
         "in three of four rounds the compute shader takes 2.6 times as long, less a fifth", true,
         [](const ClaimOptions &options) { return with_opengl(fragment_against_compute, options); }},
        {"C16", "rasterisation is fast, ray tracing accurate but slow", "17_gpu",
         "A ball on a table under two lamps, by depth buffer and shadow maps of 1024 x 1024 (all made anew for each "
         "picture) and by ray tracing, by the same OpenGL, in turns; errors against the CPU's picture in double",
         "rasterisation takes less than half the time, and ray tracing has less than half the wrong pixels", true,
         [](const ClaimOptions &options) { return with_opengl(rasterised_against_traced, options); }}};
}

} // namespace course
