#include "chapters/16_comparison/scenes.hpp"
#include "chapters/08_mesh/load.hpp"
#include "chapters/16_comparison/built_scenes.hpp"
#include "chapters/16_comparison/hall.hpp"
#include "chapters/16_comparison/landscape.hpp"
#include "chapters/16_comparison/scattered.hpp"
#include "common/errors.hpp"

#include <algorithm>

namespace course {

TestScene seen_from(const std::string &name, Triangles triangles, const Vec<double> &from) {
    const Box<float> box = bounds(std::span<const Triangle<>>(triangles));
    const double size = length(extent(box));
    const Viewpoint view{centre(box) + 1.25 * size * normalize(from), centre(box), {0, 1, 0}, 45};
    const Vec<double> left = normalize(cross(Vec<double>(0, 1, 0), from + Vec<double>(1e-3, 0, 0)));
    return {name, std::move(triangles), view, view.eye - size * left + Vec<double>(0, size, 0)};
}

TestScene from_file(const std::filesystem::path &file) {
    const Mesh<> mesh = load_mesh(file);
    if (count_faults(mesh).without_area == size(mesh))
        throw InputError(file.string(), "no triangle has an area, so no ray can hit it");
    return seen_from(file.stem().string(), triangles(mesh), {0.3, 0.35, 1});
}

Triangles bunny() { return triangles(load_mesh(find_bunny())); }

Triangles subdivided(Triangles list, int level) {
    for (; level > 0; --level) {
        Triangles finer;
        finer.reserve(4 * list.size());
        for (const auto &[a, b, c] : list) {
            const Vec<float> ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        list = std::move(finer);
    }
    return list;
}

namespace {

// The bunny alone in a stadium: rows of seats around it, a thousand times as wide. The eye sees the bunny from near.
TestScene stadium() {
    TestScene scene = seen_from("stadium", bunny(), {0.3, 0.35, 1});
    const Box<float> box = bounds(std::span<const Triangle<>>(scene.triangles));
    const double size = length(extent(box)), ground = static_cast<double>(box.lo.y);
    add_patch(scene.triangles, 128, 40, [&](double u, double v) { // up by steps: v counts treads and risers in turn
        const int step = static_cast<int>(40 * v + 0.5);
        const double far = size * (300 + 10 * ((step + 1) / 2)), high = size * 5 * (step / 2);
        return Vec<double>(far * std::cos(2 * pi * u), ground + high, -0.7 * far * std::sin(2 * pi * u));
    });
    add_patch(scene.triangles, 1, 1, [&](double u, double v) {
        return Vec<double>(1000 * size * (u - 0.5), ground, 1000 * size * (0.5 - v));
    });
    return scene;
}

} // namespace

const std::vector<SceneMaker> &scene_makers() {
    static const Vec<double> front(0.3, 0.35, 1), above(0.2, 0.9, 1);
    static const std::vector<SceneMaker> makers{
        {"bunny", true, [](bool, std::uint64_t) { return seen_from("bunny", bunny(), front); }},
        {"bunny-million", true,
         [](bool quick, std::uint64_t) {
             return seen_from("bunny-million", subdivided(bunny(), quick ? 1 : 2), front);
         }},
        {"stadium", false, [](bool, std::uint64_t) { return stadium(); }},
        {"soup", false,
         [](bool quick, std::uint64_t seed) {
             return seen_from("soup", triangle_soup(quick ? 100'000 : 1'000'000, seed), front);
         }},
        {"needles", false,
         [](bool quick, std::uint64_t seed) {
             return seen_from("needles", needles(quick ? 10'000 : 100'000, seed), front);
         }},
        {"hair", false,
         [](bool quick, std::uint64_t seed) {
             return seen_from("hair", hair(quick ? 3'000 : 30'000, 8, seed), front);
         }},
        {"sphereflake", true,
         [](bool quick, std::uint64_t) {
             return seen_from("sphereflake", quick ? sphereflake(3, 1) : sphereflake(4, 1), front);
         }},
        {"hall", true,
         [](bool quick, std::uint64_t) {
             TestScene scene = seen_from("hall", hall(8, quick ? 2 : 8), front);
             scene.view = {{1.2, 1.7, 11}, {-0.2, 2.6, 0}, {0, 1, 0}, 60};
             scene.light = {-9, 7, 4};
             return scene;
         }},
        {"terrain", true,
         [](bool quick, std::uint64_t seed) { return seen_from("terrain", terrain(quick ? 180 : 720, seed), above); }},
        {"tetra", true, [](bool quick, std::uint64_t) { return seen_from("tetra", tetra(quick ? 7 : 9), front); }},
        {"rings", true,
         [](bool quick, std::uint64_t seed) {
             return seen_from("rings", quick ? rings(5, 24, 12, seed) : rings(10, 32, 16, seed), front);
         }},
        {"gears", true, [](bool quick, std::uint64_t) { return seen_from("gears", gears(quick ? 4 : 9, 24), front); }},
        {"mount", true,
         [](bool quick, std::uint64_t seed) {
             return seen_from("mount", quick ? mount(6, 3, seed) : mount(9, 5, seed), above);
         }},
        {"tree", true,
         [](bool quick, std::uint64_t seed) {
             return seen_from("tree", quick ? tree(6, 8, seed) : tree(8, 12, seed), front);
         }},
        {"ten-million", true,
         [](bool quick, std::uint64_t seed) {
             return seen_from("ten-million", terrain(quick ? 710 : 2240, seed), above);
         },
         true},
    };
    return makers;
}

} // namespace course
