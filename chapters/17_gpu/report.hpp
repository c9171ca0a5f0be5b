// Lesson 17, step 11: what was measured, as a table, out/gpu.json, out/gpu.md and a plot.
#pragma once
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/17_gpu/bars.hpp"
#include "chapters/17_gpu/measure.hpp"

#include <cstdio>

namespace course {

inline Row row_of(const Measured &one, const Sitter &sitter, const NamedContext &on) {
    const bool cpu = one.way.stage == "cpu", raster = one.way.stage == "raster";
    Row row;
    row.set("scene", sitter.name).set("triangles", sitter.triangles);
    row.set("renderer", cpu ? "the CPU itself, in double" : on.context->renderer()).set("context", cpu ? "" : on.name);
    row.set("stage", one.way.stage)
        .set("traversal", raster || sitter.triangles == 0 ? ""
                          : cpu                           ? "stack"
                                                          : one.way.walk);
    row.set("specialised", one.way.specialised);
    row.set("compile_ms", 1e3 * one.compile_seconds).set("frame_ms", 1e3 * one.seconds);
    row.set("mrays_per_s", raster ? 0 : one.rays / one.seconds / 1e6);
    row.set("rmse_to_cpu_double", one.apart.rmse).set("differing_pixels_per_million", one.apart.differing_per_million);
    return row;
}

// How long a picture takes against the number of triangles: the balls' rows.
class TimesPlot {
  public:
    void add(const Sitter &sitter, const Measured &one) {
        const std::string name = one.way.stage == "cpu" ? "CPU, in double" : one.way.stage + ", " + one.way.walk;
        const auto known = std::ranges::find(plot_.series, name, &Series::name);
        Series &series = known != plot_.series.end() ? *known : plot_.series.emplace_back(Series{name, {}});
        series.points.push_back({static_cast<double>(sitter.triangles), 1e3 * one.seconds});
    }
    const Plot &plot() const { return plot_; }

    explicit TimesPlot(const std::string &renderer)
        : plot_{"First hits of a ball: " + renderer, "triangles", "ms for a picture", true, true, {}} {}

  private:
    Plot plot_;
};

// The ways to draw one scene, as bars.
inline BarPanel panel_of(const std::string &title, const std::vector<Measured> &ways) {
    BarPanel panel{title, {}};
    for (const Measured &measured : ways) {
        const Way &way = measured.way;
        const std::string name = way.stage == "cpu"      ? "CPU, in double"
                                 : way.stage == "raster" ? "rasterised"
                                 : !way.specialised      ? "holds everything"
                                 : way.walk == "skip"    ? "skip pointers"
                                                         : way.stage + " shader";
        panel.bars.push_back({name, colour_of_way(way.stage, way.walk, way.specialised), 1e3 * measured.seconds});
    }
    return panel;
}

inline std::string with_commas(std::size_t number) {
    std::string digits = std::to_string(number);
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), ",");
    return digits;
}

inline std::string title_of(const Sitter &sitter) {
    const std::string triangles = ", " + with_commas(sitter.triangles) + " triangles";
    return sitter.name == "whitted"   ? "Whitted's spheres"
           : sitter.name == "mirrors" ? "Two mirrors"
           : sitter.name == "bunny"   ? "The bunny and its shadows" + triangles
                                      : "First hits of a ball" + triangles;
}

// Rays per second of the bunny and of a million triangles, from the eye alone and with mirrors and shadows: what a
// graphics card is bought for.
inline void write_ray_report(const std::string &context_name, const std::string &mesh, const std::string &base,
                             bool full, std::uint64_t seed) {
    const NamedContext on = named_context(context_name);
    const int width = 1024, height = 768, rounds = full ? 9 : 3;
    Report report{"Chapter 17: rays per second", Row().set("width", width).set("height", height), {}};
    report.options.set("rounds", rounds).set("seed", seed).set("OpenGL", on.context->version());
    const auto measure = [&](const Sitter &sitter) {
        for (const Measured &one :
             measure_ways(*on.context, sitter, {{"fragment"}, {"compute"}, {"cpu"}}, width, height, rounds))
            report.results.push_back(row_of(one, sitter, on));
    };
    const Studio bunny = studio_of(mesh), million = studio(ball(8));
    measure({"bunny, first hits", size(bunny.mesh()), first_hits_exhibit(bunny)});
    measure({"bunny of enamel", size(bunny.mesh()), enamel_exhibit(bunny)});
    measure({"ball, first hits", size(million.mesh()), first_hits_exhibit(million)});
    measure({"ball of enamel", size(million.mesh()), enamel_exhibit(million)});
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(base + "_rays.json", report);
    write_markdown(base + "_rays.md", report);
    std::printf("by %s; %s_rays.md\n", on.context->renderer().c_str(), base.c_str());
}

// Everything in one run. `full`: larger pictures and meshes, more rounds.
inline void write_gpu_report(const std::string &context_name, const std::string &mesh, const std::string &base,
                             bool full, std::uint64_t seed) {
    const NamedContext on = named_context(context_name);
    const int width = full ? 640 : 192, height = full ? 360 : 108, rounds = full ? 7 : 3;
    Report report{
        "Chapter 17: the tracer on a GPU", Row().set("full", full).set("width", width).set("height", height), {}};
    report.options.set("rounds", rounds).set("seed", seed).set("OpenGL", on.context->version());
    TimesPlot times(on.context->renderer());
    char size[80];
    std::snprintf(size, sizeof size, "%d x %d, one sample a pixel; the median of %d rounds in turns", width, height,
                  rounds);
    BarChart bars("A picture's time by " + on.context->renderer() + " and by the CPU", size);
    const int last = full ? 8 : 6;
    const auto measure = [&](const Sitter &sitter, const std::vector<Way> &ways, bool shown = true) {
        const auto found = measure_ways(*on.context, sitter, ways, width, height, rounds);
        for (const Measured &one : found) {
            report.results.push_back(row_of(one, sitter, on));
            if (sitter.name == "ball")
                times.add(sitter, one);
        }
        if (shown)
            bars.add(panel_of(title_of(sitter), found));
    };
    const Limits limits{.least_weight = 0x1p-10f};
    for (const std::string name : {"whitted", "mirrors"})
        measure({name, 0, exhibit_named(name, "", limits, seed)},
                {{"fragment"}, {"compute"}, {"fragment", "stack", false}, {"cpu"}});
    measure(mesh_sitter("bunny", studio_of(mesh)),
            {{"fragment"}, {"compute"}, {"fragment", "skip"}, {"raster"}, {"cpu"}});
    for (int level = 2; level <= last; level += full ? 1 : 2)
        measure(ball_sitter(level), {{"fragment"}, {"compute"}, {"fragment", "skip"}, {"cpu"}}, level == last);

    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(base + ".json", report);
    write_markdown(base + ".md", report);
    bars.write(base + ".svg");
    write_plot(base + "_triangles.svg", times.plot());
    std::printf("by %s; %s.md\n", on.context->renderer().c_str(), base.c_str());
}

} // namespace course
