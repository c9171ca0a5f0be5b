// Lesson 17, step 7: all #defines of a scene's shader: what its type needs, and its lists by name.
#pragma once
#include "chapters/17_gpu/pack.hpp"

#include <cctype>

namespace course {

// How a mesh's boxes are walked through: with a stack, near ones first, or by skip pointers.
inline const std::vector<std::string> walk_names{"stack", "skip"};

// The scene's lists in its order, one macro call each, for closest.glsl.
inline std::string list_calls(const std::vector<ShapeRun> &runs) {
    std::string calls;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        std::string small = runs[i].kind;
        std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
        calls += runs[i].kind == "TREE"
                     ? "TREE(" + std::to_string(i) + ") "
                     : "LIST(" + std::to_string(i) + ", " + runs[i].kind + ", " + small + "_size, " + small + "_at) ";
    }
    return calls;
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
    defines["SCENE_LISTS"] = list_calls(scene.runs);
    defines["LIST_COUNT"] = std::to_string(std::max<std::size_t>(1, scene.runs.size()));
    defines["TREE_DEPTH"] = std::to_string(scene.trees.depth);
    // A ray waits for each surface that divided the light on the way to here, so the bounces are enough.
    defines["STACK_SIZE"] = std::to_string(std::clamp(scene.limits.bounces, 1, 64));
    defines["MOST_RAYS"] = "4096";
    return defines;
}

} // namespace course
