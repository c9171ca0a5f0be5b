// Lesson 16, step 18: what was asked for, measured, shown and written.
#pragma once
#include "chapters/16_comparison/compare.hpp"
#include "chapters/16_comparison/report.hpp"
#include "chapters/16_comparison/request.hpp"
#include "common/errors.hpp"
#include "common/output_files.hpp"
#include "common/parallel.hpp"

#include <cstdio>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace course {

// Wrong answers of those that must give none.
inline std::size_t mismatches_of_exact(const std::vector<Row> &rows) {
    double sum = 0;
    for (const Row &row : rows)
        if (text_of(row, "kernel") == "default")
            sum += number_of(row, "mismatches");
    return static_cast<std::size_t>(sum);
}

// The most memory that this process has ever held, in GiB.
inline double peak_gib() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 0x1p-20; // Linux counts in KiB
}

// Returns the exit status: 1 if an exact structure gave a wrong answer, 130 after Ctrl-C (what was measured is kept).
inline int run_comparison(const Request &request) {
    const std::vector<Entrant> all = contestants(), entrants = chosen_entrants(request, all);
    const Entrant &reference = find_entrant(all, "bvh");
    const Programme todo = programme(request);
    Effort effort = request.brief ? brief_effort() : request.quick ? quick_effort() : Effort{};
    effort.seed = request.seed;
    require_writable(request.report + ".json");
    keep_work_on_interrupt();
    use_threads(1); // one core for everybody, building and tracing

    Report report{
        "Acceleration structures side by side",
        Row().set("quick", request.quick).set("rays of a kind", effort.side * effort.side).set("seed", request.seed),
        {}};
    LeftOut left_out;
    const auto show = [&](const std::string &title, const std::vector<Row> &rows, const std::vector<Row> &table,
                          const std::string &without = {}) {
        report.results.insert(report.results.end(), rows.begin(), rows.end());
        if (!table.empty())
            std::printf("%s\n%s", title.c_str(), terminal_table(table).c_str());
        if (!without.empty())
            std::printf("left out: %s\n", without.c_str());
        std::printf("\n");
        std::fflush(stdout);
        write_tables(request.report, report, surface_scenes(request), left_out);
    };
    const std::size_t parts = todo.scenes.size() + static_cast<std::size_t>(todo.growth_steps);
    std::size_t part = 0;
    for (const auto &make : todo.scenes) {
        if (interrupted())
            break;
        const std::string place = std::to_string(++part) + " of " + std::to_string(parts);
        try {
            const TestScene scene = make();
            std::vector<Entrant> taking_part = entrants;
            left_out[scene.name] = leave_out(taking_part, scene.triangles.size(), effort.limits);
            const auto rows = compare_scene(scene, taking_part, reference, effort, place);
            show(scene.name + ", " + std::to_string(scene.triangles.size()) + " triangles, million rays per second",
                 rows, scene_table(rows), left_out[scene.name]);
        } catch (const InputError &error) { // the bunny is not installed
            if (!request.scenes.empty())
                throw;
            std::fprintf(stderr, "left out: %s\n", error.what());
        }
    }
    if (todo.growth_steps > 0 && !interrupted()) {
        const auto rows = compare_growth(entrants, reference, todo.growth_steps, effort, [&](const auto &so_far) {
            Report partly = report;
            partly.results.insert(partly.results.end(), so_far.begin(), so_far.end());
            write_tables(request.report, partly, surface_scenes(request), left_out);
        });
        show("Ever finer hills: nanoseconds per ray", rows, growth_table(rows));
    }
    for (const std::string peer : {"embree", "embree-avx2", "embree-robust"})
        if (const auto means = mean_table(report.results, surface_scenes(request), peer); !means.empty())
            std::printf("Speed relative to %s, geometric mean over the scenes with surfaces\n%s\n", peer.c_str(),
                        terminal_table(means).c_str());
    if (has_batches(report.results))
        std::printf("Speed relative to Embree's best call for each kind of rays, likewise\n%s\n",
                    terminal_table(best_calls_table(report.results, surface_scenes(request))).c_str());

    write_comparison(request.report, report, surface_scenes(request), left_out);
    const std::size_t wrong = mismatches_of_exact(report.results);
    std::printf("%zu rows, %zu wrong answers of the course's default kernel, peak memory %.1f GiB, %s.json\n",
                report.results.size(), wrong, peak_gib(), request.report.c_str());
    return interrupted() ? 130 : wrong ? 1 : 0;
}

} // namespace course
