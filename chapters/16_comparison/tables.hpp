// Lesson 16, step 13: from rows to tables that can be read.
#pragma once
#include "common/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace course {

inline std::string text_of(const Row &row, const std::string &name) { return std::get<std::string>(*row.find(name)); }
inline double number_of(const Row &row, const std::string &name) {
    const Value &value = *row.find(name);
    return std::holds_alternative<double>(value) ? std::get<double>(value)
                                                 : static_cast<double>(std::get<std::int64_t>(value));
}
inline std::string contestant_of(const Row &row) {
    const std::string kernel = text_of(row, "kernel");
    return text_of(row, "structure") + (kernel == "plain" ? ", plain" : "");
}

// One line for each contestant of a scene: the speeds beside each other.
inline std::vector<Row> scene_table(const std::vector<Row> &rows) {
    std::vector<Row> table;
    for (const Row &row : rows) {
        const std::string name = contestant_of(row), kind = text_of(row, "rays");
        if (table.empty() || text_of(table.back(), "structure") != name)
            table.push_back(Row()
                                .set("structure", name)
                                .set("build ms", number_of(row, "build_ms"))
                                .set("B/triangle", number_of(row, "bytes_per_triangle"))
                                .set("floor ns", number_of(row, "floor_ns"))
                                .set("wrong", 0)
                                .set("of rays", 0));
        Row &line = table.back();
        line.set("wrong", static_cast<std::int64_t>(number_of(line, "wrong") + number_of(row, "mismatches")));
        line.set("of rays", static_cast<std::int64_t>(number_of(line, "of rays") + number_of(row, "ray_count")));
        line.set(kind, number_of(row, "mrays_per_s"));
        if (kind == "bounce" && std::isfinite(number_of(row, "nodes_per_ray")))
            line.set("nodes/bounce", number_of(row, "nodes_per_ray"))
                .set("tests/bounce", number_of(row, "tests_per_ray"));
    }
    return table;
}

// The geometric mean, over the scenes named, of each contestant's speed relative to a peer's.
inline std::vector<Row> mean_table(const std::vector<Row> &rows, const std::set<std::string> &scenes,
                                   const std::string &peer = "embree") {
    std::map<std::pair<std::string, std::string>, double> of_peer; // by scene and kind
    for (const Row &row : rows)
        if (text_of(row, "structure") == peer)
            of_peer[{text_of(row, "scene"), text_of(row, "rays")}] = number_of(row, "mrays_per_s");
    std::vector<std::string> order;
    std::map<std::string, std::map<std::string, std::pair<double, int>>> logs; // by contestant and kind
    for (const Row &row : rows) {
        const auto against = of_peer.find({text_of(row, "scene"), text_of(row, "rays")});
        if (!scenes.contains(text_of(row, "scene")) || against == of_peer.end())
            continue;
        const double ratio = number_of(row, "mrays_per_s") / against->second;
        const std::string name = contestant_of(row);
        if (!logs.contains(name))
            order.push_back(name);
        auto &[sum, count] = logs[name][text_of(row, "rays")];
        sum += std::log(ratio);
        ++count;
    }
    std::vector<Row> table;
    for (const std::string &name : order) {
        Row &line = table.emplace_back();
        line.set("structure", name);
        for (const std::string kind : {"primary", "bounce", "shuffled", "shadow"})
            if (const auto at = logs[name].find(kind); at != logs[name].end())
                line.set(kind, std::exp(at->second.first / at->second.second));
    }
    return table;
}

// The slope of the straight line that fits best through the logarithms: y grows like x to that power.
inline std::optional<double> fitted_exponent(const std::vector<std::pair<double, double>> &points) {
    if (points.size() < 2)
        return {};
    double x_mean = 0, y_mean = 0, above = 0, below = 0;
    for (const auto &[x, y] : points) {
        x_mean += std::log(x) / static_cast<double>(points.size());
        y_mean += std::log(y) / static_cast<double>(points.size());
    }
    for (const auto &[x, y] : points) {
        above += (std::log(x) - x_mean) * (std::log(y) - y_mean);
        below += (std::log(x) - x_mean) * (std::log(x) - x_mean);
    }
    return above / below;
}

// How each contestant's nanoseconds per ray grow with the triangles.
struct Growth {
    std::string contestant;
    std::vector<std::pair<double, double>> points; // triangles, nanoseconds
};
inline std::vector<Growth> growth_of(const std::vector<Row> &rows, const std::string &kind) {
    std::vector<Growth> all;
    for (const Row &row : rows) {
        if (text_of(row, "scene") != "growth" || text_of(row, "rays") != kind)
            continue;
        const std::string name = contestant_of(row);
        auto at = std::ranges::find(all, name, &Growth::contestant);
        if (at == all.end())
            at = all.insert(all.end(), {name, {}});
        at->points.push_back({number_of(row, "triangles"), 1e3 / number_of(row, "mrays_per_s")});
    }
    return all;
}

} // namespace course
