// Lesson 16, step 14: rays by the batch: the wide BVH's ways to take them, against the best of Embree's calls.
#pragma once
#include "chapters/16_comparison/tables.hpp"

namespace course {

// Embree's call that is fastest for a kind of rays, of those in any mode but the robust one.
struct BestCall {
    std::string name;
    double speed = 0;
};
inline BestCall best_call(const std::vector<Row> &means, const std::string &kind) {
    BestCall best;
    for (const Row &row : means) {
        const std::string name = text_of(row, "structure");
        const Value *speed = row.find(kind);
        if (speed && name.starts_with("embree") && name != "embree-robust" && std::get<double>(*speed) > best.speed)
            best = {name, std::get<double>(*speed)};
    }
    return best;
}

// For every kind of rays the speed, relative to Embree's best call for that kind, of whoever takes rays by the batch
// and of those who do not; geometric means over the scenes named. Beside them the longest floor, in nanoseconds, of all
// these scenes. The last line says which calls were best.
inline std::vector<Row> best_calls_table(const std::vector<Row> &rows, const std::set<std::string> &scenes) {
    const std::vector<Row> means = mean_table(rows, scenes);
    const std::vector<std::string> kinds{"primary", "bounce", "shuffled", "shadow"};
    std::vector<Row> table;
    Row best = Row().set("structure", "(the best call)");
    for (const Row &row : means) {
        const std::string name = text_of(row, "structure");
        if (!(name.starts_with("wide") || name.starts_with("embree")) || name.ends_with(", plain"))
            continue;
        Row &line = table.emplace_back();
        line.set("structure", name);
        for (const std::string &kind : kinds)
            if (const Value *speed = row.find(kind))
                line.set(kind, std::get<double>(*speed) / best_call(means, kind).speed);
        double floor = 0;
        for (const Row &measured : rows)
            if (contestant_of(measured) == name && scenes.contains(text_of(measured, "scene")))
                floor = std::max(floor, number_of(measured, "floor_ns"));
        line.set("floor ns", floor);
    }
    for (const std::string &kind : kinds)
        best.set(kind, best_call(means, kind).name);
    table.push_back(best);
    return table;
}

// Whether anybody takes rays by the batch, besides one who is measured against it.
inline bool has_batches(const std::vector<Row> &rows) {
    const auto is = [&](const std::string &name) {
        return std::ranges::any_of(rows, [&](const Row &row) { return text_of(row, "structure") == name; });
    };
    return is("wide-packets") && is("embree-8-coherent");
}

} // namespace course
