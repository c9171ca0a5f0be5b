// Lesson 16, step 8: the scenes, each with a place to look at it from and a light.
#pragma once
#include "chapters/09_aabb/bounds.hpp"
#include "chapters/16_comparison/patches.hpp"
#include "common/viewpoint.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace course {

struct TestScene {
    std::string name;
    Triangles triangles;
    Viewpoint view;
    Vec<double> light;
};

// Looks at the whole of the triangles from the direction `from`; the light is behind the viewer's left shoulder.
TestScene seen_from(const std::string &name, Triangles triangles, const Vec<double> &from);

// A mesh from a file. One without a single triangle that has an area has nothing to be hit.
TestScene from_file(const std::filesystem::path &file);

Triangles bunny();

// Every triangle cut into four, flat, `level` times.
Triangles subdivided(Triangles list, int level);

// How a scene is made, in the small for --quick and in full.
struct SceneMaker {
    std::string name;
    bool surfaces; // whether it counts in the mean over surface scenes
    std::function<TestScene(bool quick, std::uint64_t seed)> make;
    bool only_when_named = false;
};

const std::vector<SceneMaker> &scene_makers();

// What --quick measures unless it is told what.
inline const std::vector<std::string> quick_scenes{"bunny", "stadium", "soup", "needles", "sphereflake", "hall"};

// What goes with the picture.
inline const std::vector<std::string> brief_scenes{"bunny", "needles", "hall"};

} // namespace course
