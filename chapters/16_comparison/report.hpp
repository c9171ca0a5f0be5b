// Lesson 16, step 15: the report: JSON for programs, Markdown and plots for people.
#pragma once
#include "chapters/16_comparison/best_calls.hpp"
#include "chapters/16_comparison/plots.hpp"
#include "common/output_files.hpp"

#include <filesystem>
#include <string>

namespace course {

inline std::vector<Row> growth_table(const std::vector<Row> &rows) {
    std::vector<Row> table;
    for (const std::string kind : {"primary", "bounce"})
        for (const Growth &growth : growth_of(rows, kind)) {
            const auto exponent = fitted_exponent(growth.points);
            table.push_back(Row()
                                .set("structure", growth.contestant)
                                .set("rays", kind)
                                .set("triangles from", growth.points.front().first)
                                .set("to", growth.points.back().first)
                                .set("ns at first", growth.points.front().second)
                                .set("ns at last", growth.points.back().second)
                                .set("grows like n to the", exponent.value_or(std::nan(""))));
        }
    return table;
}

// By scene: who did not take part, and why, in words.
using LeftOut = std::map<std::string, std::string>;

inline std::string comparison_in_markdown(const Report &report, const std::set<std::string> &surfaces,
                                          const LeftOut &left_out) {
    std::string text = "# " + report.title + "\n\nMeasured on: " + machine_in_words() + ", one core\n\n" +
                       markdown_table({report.options}) +
                       "\nSpeeds are million rays per second, the median of rounds in which the contestants took "
                       "turns. *floor* is a call with a ray that misses the scene. *wrong* counts the answers that "
                       "differ from brute force: with the default kernel in the primitive or in any bit of t, with "
                       "the plain kernel (Möller–Trumbore in float) and with peers in the primitive.\n";
    if (const auto means = mean_table(report.results, surfaces); !means.empty())
        text +=
            "\n## Speed relative to Embree, geometric mean over the scenes with surfaces\n\n" + markdown_table(means);
    if (has_batches(report.results))
        text += "\n## Speed relative to Embree's best call for each kind of rays, likewise\n\n" +
                markdown_table(best_calls_table(report.results, surfaces));
    for (const std::string &scene : scenes_in(report.results)) {
        std::vector<Row> rows;
        std::ranges::copy_if(report.results, std::back_inserter(rows),
                             [&](const Row &row) { return text_of(row, "scene") == scene; });
        text += "\n## " + scene + ", " + std::to_string(static_cast<long long>(number_of(rows.front(), "triangles"))) +
                " triangles\n\n" + markdown_table(scene_table(rows));
        if (const auto without = left_out.find(scene); without != left_out.end() && !without->second.empty())
            text += "\nLeft out: " + without->second + ".\n";
    }
    if (const auto growth = growth_table(report.results); !growth.empty())
        text += "\n## Growth\n\n" + markdown_table(growth);
    return text;
}

// `base` is a path without an ending: base.json and base.md. To be called after each scene, so that whatever ends a
// long run, what was measured is kept.
inline void write_tables(const std::string &base, const Report &report, const std::set<std::string> &surfaces,
                         const LeftOut &left_out = {}) {
    write_json(base + ".json", report);
    write_text(base + ".md", comparison_in_markdown(report, surfaces, left_out));
}

// The same with plots: base_primary.svg ...
inline void write_comparison(const std::string &base, const Report &report, const std::set<std::string> &surfaces,
                             const LeftOut &left_out = {}) {
    write_tables(base, report, surfaces, left_out);
    const auto &rows = report.results;
    if (!scenes_in(rows).empty()) {
        const std::string speed = "million rays per second";
        write_plot(base + "_primary.svg", by_scene(rows, "primary", "mrays_per_s", "Primary rays", speed));
        write_plot(base + "_bounce.svg", by_scene(rows, "bounce", "mrays_per_s", "Bounce rays", speed));
        write_plot(base + "_memory.svg",
                   by_scene(rows, "primary", "bytes_per_triangle", "Memory", "bytes per triangle"));
        write_plot(base + "_build.svg", build_against_speed(rows));
        write_plot(base + "_error.svg", speed_against_error(rows));
    }
    if (!growth_of(rows, "primary").empty())
        write_plot(base + "_growth.svg", growth_plot(rows, "primary"));
}

} // namespace course
