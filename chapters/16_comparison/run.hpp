// Lesson 16, step 17: what was asked for, measured, shown and written.
#pragma once
#include "chapters/16_comparison/compare.hpp"
#include "chapters/16_comparison/report.hpp"
#include "common/output_files.hpp"
#include "common/parallel.hpp"

#include <cstdio>
#include <set>
#include <string>
#include <vector>

namespace course {

struct Request {
    bool quick = false;
    bool brief = false;                                  // of the quick scenes, only as many as go into a minute
    std::vector<std::string> scenes, meshes, structures; // empty: all
    std::string report = "out/compare";                  // .json, .md, _*.svg
    std::uint64_t seed = 1;
};

// Throws InputError unless every wanted name is among the known ones.
inline void require_known(const std::string &option, const std::vector<std::string> &wanted,
                          const std::vector<std::string> &known) {
    for (const std::string &name : wanted)
        if (std::ranges::find(known, name) == known.end()) {
            std::string list;
            for (const std::string &one : known)
                list += (list.empty() ? "" : ", ") + one;
            throw InputError(option + " " + name, "there is none of that name, but there are: " + list);
        }
}

inline std::vector<Entrant> chosen_entrants(const Request &request, const std::vector<Entrant> &all) {
    std::vector<std::string> known;
    for (const Entrant &entrant : all)
        if (std::ranges::find(known, entrant.structure) == known.end())
            known.push_back(entrant.structure);
    require_known("--structure", request.structures, known);
    std::vector<Entrant> list = all;
    std::erase_if(list, [&](const Entrant &entrant) { // one box is brute force again wherever a ray meets the scene
        return request.structures.empty()
                   ? entrant.structure == "box"
                   : std::ranges::find(request.structures, entrant.structure) == request.structures.end();
    });
    return list;
}

// What is to be measured: meshes and scenes that were named, or else the usual ones.
struct Programme {
    std::vector<std::function<TestScene()>> scenes;
    int growth_steps = 0;
};

inline Programme programme(const Request &request) {
    std::vector<std::string> known{"growth"}, names = request.scenes;
    for (const SceneMaker &maker : scene_makers())
        known.push_back(maker.name);
    require_known("--scene", request.scenes, known);
    if (names.empty() && request.meshes.empty())
        names = request.brief ? brief_scenes : request.quick ? quick_scenes : known;
    Programme result;
    for (const std::string &file : request.meshes)
        result.scenes.push_back([scene = from_file(file)] { return scene; }); // read now: bad input ends it all early
    for (const SceneMaker &maker : scene_makers())
        if (std::ranges::find(names, maker.name) != names.end())
            result.scenes.push_back([&maker, request] { return maker.make(request.quick, request.seed); });
    const bool usual = request.scenes.empty() && request.meshes.empty();
    if (usual || std::ranges::find(names, "growth") != names.end())
        result.growth_steps = request.brief   ? 4
                              : request.quick ? 5
                                              : 7; // to 68 or 271 thousand triangles, or 4.3 million
    return result;
}

inline std::set<std::string> surface_scenes(const Request &request) {
    std::set<std::string> names;
    for (const SceneMaker &maker : scene_makers())
        if (maker.surfaces)
            names.insert(maker.name);
    for (const std::string &file : request.meshes)
        names.insert(std::filesystem::path(file).stem().string());
    return names;
}

// Wrong answers of those that must give none.
inline std::size_t mismatches_of_exact(const std::vector<Row> &rows) {
    double sum = 0;
    for (const Row &row : rows)
        if (text_of(row, "kernel") == "default")
            sum += number_of(row, "mismatches");
    return static_cast<std::size_t>(sum);
}

// Returns the exit status: 1 if an exact structure gave a wrong answer, 130 after Ctrl-C (what was measured is kept).
inline int run_comparison(const Request &request) {
    const std::vector<Entrant> all = contestants(), entrants = chosen_entrants(request, all);
    const Entrant &reference = find_entrant(all, "bvh");
    const Programme todo = programme(request);
    Effort effort = request.quick ? quick_effort() : Effort{};
    effort.seed = request.seed;
    require_writable(request.report + ".json");
    keep_work_on_interrupt();
    use_threads(1); // one core for everybody, building and tracing

    Report report{
        "Acceleration structures side by side",
        Row().set("quick", request.quick).set("rays of a kind", effort.side * effort.side).set("seed", request.seed),
        {}};
    const auto show = [&](const std::string &title, const std::vector<Row> &rows, const std::vector<Row> &table) {
        report.results.insert(report.results.end(), rows.begin(), rows.end());
        if (!table.empty())
            std::printf("%s\n%s\n", title.c_str(), terminal_table(table).c_str());
        std::fflush(stdout);
    };
    for (const auto &make : todo.scenes) {
        if (interrupted())
            break;
        try {
            const TestScene scene = make();
            const auto rows = compare_scene(scene, entrants, reference, effort);
            show(scene.name + ", " + std::to_string(scene.triangles.size()) + " triangles, million rays per second",
                 rows, scene_table(rows));
        } catch (const InputError &error) { // the bunny is not installed
            if (!request.scenes.empty())
                throw;
            std::fprintf(stderr, "left out: %s\n", error.what());
        }
    }
    if (todo.growth_steps > 0 && !interrupted()) {
        const auto rows = compare_growth(entrants, reference, todo.growth_steps, effort);
        show("Ever finer hills: nanoseconds per ray", rows, growth_table(rows));
    }
    if (const auto means = mean_table(report.results, surface_scenes(request)); !means.empty())
        std::printf("Speed relative to Embree, geometric mean over the scenes with surfaces\n%s\n",
                    terminal_table(means).c_str());

    write_comparison(request.report, report, surface_scenes(request));
    const std::size_t wrong = mismatches_of_exact(report.results);
    std::printf("%zu rows, %zu wrong answers of the course's default kernel, %s.json\n", report.results.size(), wrong,
                request.report.c_str());
    return interrupted() ? 130 : wrong ? 1 : 0;
}

} // namespace course
