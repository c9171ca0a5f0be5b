// Lesson 16, step 12: every scene, every contestant, every kind of rays: the rows of the report.
#pragma once
#include "chapters/16_comparison/landscape.hpp"
#include "chapters/16_comparison/limits.hpp"
#include "chapters/16_comparison/measure.hpp"
#include "common/progress.hpp"
#include "common/report.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace course {

inline const Entrant &find_entrant(const std::vector<Entrant> &entrants, const std::string &structure) {
    return *std::ranges::find_if(entrants, [&](const Entrant &e) { return e.structure == structure; });
}

// One scene with some kinds of rays. Rays that miss everything give no rows but the others' floor_ns.
// `reference` is who answers for the rays that brute force has no time for.
inline std::vector<Row> rows_of(const TestScene &scene, const std::vector<Ready> &ready, const Entrant &reference,
                                const std::set<std::string> &kinds, const Effort &effort, Progress &progress) {
    const auto tracer = reference.build(scene.triangles);
    const Scene<Triangle<>> brute(scene.triangles);
    const auto count = static_cast<double>(scene.triangles.size());
    std::map<std::string, std::vector<Result>> results;
    std::vector<Row> rows;
    for (const RayBatch &batch : ray_batches(scene, *tracer, effort.side, effort.seed)) {
        progress.advance();
        if (!interrupted() && (kinds.contains(batch.kind) || batch.kind == "miss"))
            results[batch.kind] = race(ready, batch, truth_of(batch, brute, *tracer, effort.brute_tests), effort);
    }
    if (interrupted())
        return {};
    for (std::size_t i = 0; i < ready.size(); ++i)
        for (const std::string kind : {"primary", "bounce", "shuffled", "shadow"}) {
            const auto at = results.find(kind);
            if (at == results.end())
                continue;
            const Result &result = at->second[i];
            double embree = unknown;
            for (std::size_t other = 0; other < ready.size(); ++other)
                if (ready[other].entrant->structure == "embree")
                    embree = at->second[other].mrays_per_s;
            rows.push_back(Row()
                               .set("scene", scene.name)
                               .set("triangles", scene.triangles.size())
                               .set("structure", ready[i].entrant->structure)
                               .set("kernel", ready[i].entrant->kernel)
                               .set("rays", kind)
                               .set("ray_count", result.rays)
                               .set("build_ms", 1e3 * ready[i].build_seconds)
                               .set("bytes_per_triangle", static_cast<double>(ready[i].built->bytes()) / count)
                               .set("mrays_per_s", result.mrays_per_s)
                               .set("ratio_to_embree", result.mrays_per_s / embree)
                               .set("nodes_per_ray", result.nodes)
                               .set("tests_per_ray", result.tests)
                               .set("mismatches", result.verdict.mismatches)
                               .set("leaks", result.verdict.leaks)
                               .set("floor_ns", 1e3 / results.at("miss")[i].mrays_per_s));
        }
    return rows;
}

inline const std::set<std::string> all_kinds{"primary", "bounce", "shuffled", "shadow"};

// With whoever the limits do not keep away. `place` says to those who wait which scene of how many this is.
inline std::vector<Row> compare_scene(const TestScene &scene, std::vector<Entrant> entrants, const Entrant &reference,
                                      const Effort &effort, const std::string &place = {}) {
    leave_out(entrants, scene.triangles.size(), effort.limits);
    Progress progress(place.empty() ? scene.name : place + ", " + scene.name, 6);
    const std::vector<Ready> ready = build_all(entrants, scene.triangles, effort);
    progress.advance();
    return rows_of(scene, ready, reference, all_kinds, effort, progress);
}

// The same hills cut ever finer, from a thousand triangles on, each time four times as many. Whose build took longer
// than the effort allows does not take part in the next. Only default kernels and peers. keep(rows) is called with what
// there is after each size.
inline std::vector<Row> compare_growth(
    const std::vector<Entrant> &entrants, const Entrant &reference, int steps, const Effort &effort,
    const std::function<void(const std::vector<Row> &)> &keep = [](const auto &) {}) {
    std::vector<Entrant> left = entrants;
    std::erase_if(left, [](const Entrant &e) { return e.kernel == "plain"; });
    std::vector<Row> rows;
    for (int i = 0, cells = 23; i < steps && !interrupted(); ++i, cells *= 2) {
        TestScene scene = seen_from("growth", terrain(cells, effort.seed), {0.2, 0.9, 1});
        leave_out(left, scene.triangles.size(), effort.limits);
        Progress progress("growth " + std::to_string(i + 1) + " of " + std::to_string(steps) + ", " +
                              std::to_string(scene.triangles.size()) + " triangles",
                          6);
        const std::vector<Ready> ready = build_all(left, scene.triangles, effort);
        progress.advance();
        for (Row &row : rows_of(scene, ready, reference, {"primary", "bounce"}, effort, progress))
            rows.push_back(std::move(row));
        keep(rows);
        std::vector<Entrant> next;
        for (const Ready &one : ready)
            if (one.build_seconds <= effort.longest_build)
                next.push_back(*one.entrant);
        left = std::move(next); // `ready` points into the old list, and ends here
    }
    return rows;
}

} // namespace course
