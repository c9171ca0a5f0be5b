// Lesson 16, step 17: what was asked for: scenes, structures, effort.
#pragma once
#include "chapters/16_comparison/contest.hpp"
#include "chapters/16_comparison/scenes.hpp"
#include "common/errors.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace course {

struct Request {
    bool quick = false;
    bool brief = false;                                  // of the quick scenes, only as many as go into twenty seconds
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
    const auto is_named = [&](const Entrant &entrant) { // "embree" also names embree-robust, "wide" all its variants
        return std::ranges::any_of(request.structures, [&](const std::string &name) {
            const bool is_variant = entrant.on_request || !entrant.ours();
            return entrant.structure == name || (is_variant && entrant.structure.starts_with(name + "-"));
        });
    };
    std::erase_if(list, [&](const Entrant &entrant) { // one box is brute force again wherever a ray meets the scene
        return request.structures.empty() ? entrant.structure == "box" || entrant.on_request : !is_named(entrant);
    });
    return list;
}

// What is to be measured: meshes and scenes that were named, or else the usual ones.
struct Programme {
    std::vector<std::function<TestScene()>> scenes;
    int growth_steps = 0;
};

inline Programme programme(const Request &request) {
    std::vector<std::string> known{"growth"}, all, names = request.scenes;
    for (const SceneMaker &maker : scene_makers()) {
        known.push_back(maker.name);
        if (!maker.only_when_named)
            all.push_back(maker.name);
    }
    require_known("--scene", request.scenes, known);
    if (names.empty() && request.meshes.empty())
        names = request.brief ? brief_scenes : request.quick ? quick_scenes : all;
    Programme result;
    for (const std::string &file : request.meshes)
        result.scenes.push_back([scene = from_file(file)] { return scene; }); // read now: bad input ends it all early
    for (const SceneMaker &maker : scene_makers())
        if (std::ranges::find(names, maker.name) != names.end())
            result.scenes.push_back([&maker, request] { return maker.make(request.quick, request.seed); });
    const bool usual = request.scenes.empty() && request.meshes.empty();
    if (usual || std::ranges::find(names, "growth") != names.end())
        result.growth_steps = request.brief   ? 3
                              : request.quick ? 5
                                              : 7; // to 17 or 271 thousand triangles, or 4.3 million
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

} // namespace course
