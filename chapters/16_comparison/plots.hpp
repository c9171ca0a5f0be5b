// Lesson 16, step 14: from rows to plots.
#pragma once
#include "chapters/16_comparison/tables.hpp"
#include "common/plot.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace course {

inline std::string two_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

// The scenes in the order of the rows, without the series of ever finer hills.
inline std::vector<std::string> scenes_in(const std::vector<Row> &rows) {
    std::vector<std::string> scenes;
    for (const Row &row : rows)
        if (const std::string scene = text_of(row, "scene");
            scene != "growth" && std::ranges::find(scenes, scene) == scenes.end())
            scenes.push_back(scene);
    return scenes;
}

// A family has one colour throughout the plots, and its members differ by their lines and marks: more than eight
// colours nobody can tell apart.
inline Series series_of(const std::string &name, Series::Style style = Series::Style::line_and_points) {
    constexpr std::array<std::pair<const char *, int>, 9> families{{{"bvh", 0},
                                                                    {"wide", 1},
                                                                    {"kd", 2},
                                                                    {"cgal", 3},
                                                                    {"octree", 4},
                                                                    {"grid", 5},
                                                                    {"embree", 6},
                                                                    {"bsp", 7},
                                                                    {"none", 7}}};
    const auto family = std::ranges::find_if(families, [&](const auto &f) { return name.starts_with(f.first); });
    const auto is = [&](const char *kind) { return name.find(kind) != std::string::npos; };
    const int dash = is("-median") || is("-robust")               ? 2
                     : is("-middle") || is("-avx2") || is("none") ? 3
                     : is("-sah") || !is("-")                     ? 1
                                                                  : 4;
    return {name, {}, style, family == families.end() ? -1 : family->second, dash};
}

// One point for each scene, at its number: a value of the rows of one kind. Brute force stays out: so slow that all
// others would lie in one line at the top.
inline Plot by_scene(const std::vector<Row> &rows, const std::string &kind, const std::string &value,
                     const std::string &title, const std::string &y_label) {
    const auto scenes = scenes_in(rows);
    Plot plot{title, "", y_label, false, true, {}, scenes};
    for (const Row &row : rows) {
        const auto scene = std::ranges::find(scenes, text_of(row, "scene"));
        const std::string name = contestant_of(row);
        if (scene == scenes.end() || text_of(row, "rays") != kind || text_of(row, "kernel") == "plain" ||
            name == "box" || name == "none")
            continue;
        auto at = std::ranges::find(plot.series, name, &Series::name);
        if (at == plot.series.end())
            at = plot.series.insert(plot.series.end(), series_of(name));
        at->points.push_back({static_cast<double>(scene - scenes.begin() + 1), number_of(row, value)});
    }
    return plot;
}

// Each scene a point: what the build of a triangle took, and how fast bounce rays then are.
inline Plot build_against_speed(const std::vector<Row> &rows) {
    Plot plot{
        "Time to build, and what it buys", "build, ns per triangle", "million bounce rays per second", true, true, {}};
    for (const Row &row : rows) {
        const std::string name = contestant_of(row), structure = text_of(row, "structure");
        if (text_of(row, "scene") == "growth" || text_of(row, "rays") != "bounce" ||
            text_of(row, "kernel") == "plain" || structure == "none" || structure == "box")
            continue;
        auto at = std::ranges::find(plot.series, name, &Series::name);
        if (at == plot.series.end())
            at = plot.series.insert(plot.series.end(), series_of(name, Series::Style::points));
        at->points.push_back(
            {1e6 * number_of(row, "build_ms") / number_of(row, "triangles"), number_of(row, "mrays_per_s")});
    }
    return plot;
}

// From the default kernel to the plain one: what is gained in speed and lost in right answers, all scenes together.
inline Plot speed_against_error(const std::vector<Row> &rows) {
    struct Sum {
        double log_speed = 0, count = 0, rays = 0, wrong = 0;
    };
    // Where both kernels ran, so that both are judged by the same scenes. (The BVH runs both everywhere.)
    std::set<std::string> scenes;
    for (const Row &row : rows)
        if (text_of(row, "kernel") == "plain" && text_of(row, "structure") != "bvh")
            scenes.insert(text_of(row, "scene"));
    std::vector<std::string> order;
    std::map<std::string, std::map<std::string, Sum>> sums; // by structure and kernel
    for (const Row &row : rows) {
        const std::string structure = text_of(row, "structure");
        if (text_of(row, "scene") == "growth" || structure == "none" || structure == "box" ||
            (!scenes.empty() && !scenes.contains(text_of(row, "scene"))))
            continue;
        if (!sums.contains(structure))
            order.push_back(structure);
        Sum &sum = sums[structure][text_of(row, "kernel")];
        sum.log_speed += std::log(number_of(row, "mrays_per_s"));
        sum.count += 1;
        sum.rays += number_of(row, "ray_count");
        sum.wrong += number_of(row, "mismatches");
    }
    Plot plot{"Speed and error: default kernel, and plain in float",
              "wrong answers per million rays",
              "million rays per second (mean)",
              true,
              false,
              {}};
    for (const std::string &structure : order) {
        Series &series = plot.series.emplace_back(series_of(structure));
        for (const auto &[kernel, sum] : sums[structure])
            series.points.push_back({1e6 * sum.wrong / sum.rays, std::exp(sum.log_speed / sum.count)});
    }
    return plot;
}

inline Plot growth_plot(const std::vector<Row> &rows, const std::string &kind) {
    Plot plot{
        "Cost against size, with the power of n that fits", "triangles", "ns per " + kind + " ray", true, true, {}};
    for (const Growth &growth : growth_of(rows, kind)) {
        if (growth.contestant == "box")
            continue;
        const auto exponent = fitted_exponent(growth.points);
        Series &series =
            plot.series.emplace_back(series_of(growth.contestant + (exponent ? " " + two_digits(*exponent) : "")));
        for (const auto &[triangles, nanoseconds] : growth.points)
            series.points.push_back({triangles, nanoseconds});
    }
    return plot;
}

} // namespace course
