// Lesson 17, step 8: all #defines of a scene's shader: what its type needs, and its lists by name.
#pragma once
#include "chapters/17_gpu/pack.hpp"

#include <cctype>
#include <set>

namespace course {

// How a mesh's boxes are walked through: with a stack, near ones first, or by skip pointers.
inline const std::vector<std::string> walk_names{"stack", "skip"};

inline std::string in_small(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name;
}

// The scene's lists in its order, one macro call each, for closest.glsl.
inline std::string list_calls(const std::vector<ShapeRun> &runs) {
    std::string calls;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::string small = in_small(runs[i].kind);
        calls += runs[i].kind == "TREE"
                     ? "TREE(" + std::to_string(i) + ") "
                     : "LIST(" + std::to_string(i) + ", " + runs[i].kind + ", " + small + "_size, " + small + "_at) ";
    }
    return calls;
}

// Its kinds of shape, each once. What is hit in a tree is a triangle.
inline std::string kind_calls(const std::vector<ShapeRun> &runs) {
    std::set<std::string> kinds;
    for (const ShapeRun &run : runs)
        kinds.insert(run.kind == "TREE" ? "TRIANGLE" : run.kind);
    std::string calls;
    for (const std::string &kind : kinds)
        calls += "ONE_KIND(" + kind + ", " + in_small(kind) + "_at) ";
    return calls;
}

// Runs of at most 8 shapes, which compilers write out instead of looping: a third faster here, and on llvmpipe no
// round of a loop is spent. A scene of very many shapes keeps its loops.
inline std::vector<ShapeRun> short_runs(const std::vector<ShapeRun> &runs) {
    constexpr int longest = 8, most = 128;
    std::vector<ShapeRun> pieces;
    int total = 0;
    for (const ShapeRun &run : runs) {
        total += run.count;
        for (int i = 0; i < run.count; i += longest)
            pieces.push_back({run.kind, run.first + i * run.size, std::min(longest, run.count - i), run.size});
    }
    return total > most ? runs : pieces;
}

inline std::string in_glsl(int first, int count) {
    return "ivec2(" + std::to_string(first) + ", " + std::to_string(count) + ")";
}

inline Defines shader_defines(const PackedScene &scene, const std::string &walk = "stack") {
    Defines defines = scene.defines;
    const auto any_of = [&](std::initializer_list<const char *> names) {
        return std::ranges::any_of(names, [&](const char *name) { return defines.contains(name); });
    };
    if (any_of({"HAS_PLANE", "HAS_DISK", "HAS_TRIANGLE"}))
        need(defines, "HAS_FLAT");
    if (any_of({"HAS_BOX", "HAS_QUARTIC"}))
        need(defines, "HAS_CUBOID");
    if (any_of({"HAS_CYLINDER", "HAS_CONE", "HAS_QUARTIC"}))
        need(defines, "HAS_QUADRIC");
    if (walk == "skip")
        need(defines, "WALK_SKIP");
    const std::vector<ShapeRun> runs = scene.specialised ? short_runs(scene.runs) : scene.runs;
    defines["SCENE_LISTS"] = list_calls(runs);
    defines["SCENE_KINDS"] = kind_calls(runs);
    defines["LIST_COUNT"] = std::to_string(std::max<std::size_t>(1, runs.size()));
    if (scene.specialised && !runs.empty()) {
        for (const ShapeRun &run : runs)
            defines["LIST_TABLE"] += (&run == &runs.front() ? "" : ", ") + in_glsl(run.first, run.count);
        defines["LIGHT_RUN"] = in_glsl(scene.first_light, scene.light_count);
    }
    defines["TREE_DEPTH"] = std::to_string(scene.trees.depth);
    defines["LAMP_SIZE"] = std::to_string(scene.lamp_size);
    defines["STACK_SIZE"] = std::to_string(std::max(1, scene.ray_stack));
    defines["MOST_RAYS"] = "32768";
    return defines;
}

} // namespace course
