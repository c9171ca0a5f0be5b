// H12: every structure answers as brute force does, bit for bit: the nearest hit, and whether a shadow ray is stopped.
// The scenes are those on which structures are wont to fail; mesh_cases.cpp has the closed meshes, seen from inside.
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/03_light_and_shadow/any_hit.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
#include "tests/hard_cases/structures.hpp"
#include "tests/hard_cases/suites.hpp"
#include "tests/structures/scenes.hpp"

#include <atomic>
#include <bit>
#include <cmath>

namespace course::hard {
namespace {

using structure_test::hard_rays, structure_test::needles, structure_test::soup, structure_test::voxels;

struct HardScene {
    std::string name;
    std::vector<Triangle<>> triangles;
};

std::vector<HardScene> hard_scenes(std::uint64_t seed) {
    auto flat = soup(200, 0.3, seed);
    for (auto &[a, b, c] : flat)
        a.y = b.y = c.y = 0.25f;
    return {
        {"cubes on a lattice", voxels(4, seed).triangles},
        {"needles", needles(200, seed)},
        {"all in one plane", flat},
        {"soup at (148376, 1234, -223423)", structure_test::scaled(soup(200, 0.3, seed), 10, {148376, 1234, -223423})},
        {"soup 1e-6 large", structure_test::scaled(soup(200, 0.3, seed), 1e-6f)}};
}

// Which of the kinds that hard_rays() makes in turns, and whether the ray is asked as a shadow ray.
struct RayKind {
    std::string name;
    std::size_t number;
    bool shadow;
};
const std::vector<RayKind> ray_kinds{{"at corners", 1, false},
                                     {"at edges", 2, false},
                                     {"along an axis through a corner", 4, false},
                                     {"nearly along an axis", 5, false},
                                     {"in a triangle's plane", 7, false},
                                     {"as fast along two axes", 8, false},
                                     {"shadow rays at corners", 1, true},
                                     {"shadow rays from surfaces", 6, true}};

// A shadow ray ends just before what it would meet, exactly there, or a rounding error after it.
void end_near_hit(Ray<double> &ray, double t, std::size_t i) {
    if (std::isfinite(t) && i % 4 != 0)
        ray.t_max = i % 4 == 1 ? t : i % 4 == 2 ? std::nextafter(t, infinity<double>) : std::nextafter(t, 0.0);
}

// The same chunk of rays for every structure, with brute force's answers.
struct Asked {
    std::vector<Ray<double>> rays;
    std::vector<Hit<double>> hits;
    std::vector<unsigned char> stopped;
};

Asked ask_brute_force(const HardScene &scene, const Scene<Triangle<>> &brute, const RayKind &kind, std::uint64_t stream,
                      std::size_t count) {
    Asked asked;
    const auto all = hard_rays(scene.triangles, structure_test::kinds_of_hard_rays * count, stream);
    for (std::size_t i = 0; i < count; ++i) {
        Ray<double> ray = all[structure_test::kinds_of_hard_rays * i + kind.number];
        if (kind.shadow)
            end_near_hit(ray, closest_hit(ray, brute).t, i);
        asked.rays.push_back(ray);
        asked.hits.push_back(closest_hit(ray, brute));
        asked.stopped.push_back(any_hit(ray, brute));
    }
    return asked;
}

std::uint64_t disagreements(const Asked &asked, const Built &structure, bool shadow) {
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < asked.rays.size(); ++i)
        if (shadow)
            wrong += structure.any(asked.rays[i]) != (asked.stopped[i] != 0);
        else {
            const auto found = structure.closest(asked.rays[i]);
            wrong += found.id != asked.hits[i].id ||
                     std::bit_cast<std::uint64_t>(found.t) != std::bit_cast<std::uint64_t>(asked.hits[i].t);
        }
    return wrong;
}

Outcome agreement(const Settings &settings) {
    Outcome outcome;
    const std::size_t cases = settings.quick ? settings.cases / 40 : settings.cases / 8;
    const std::size_t chunk_size = 512, chunks = (cases + chunk_size - 1) / chunk_size;
    const auto scenes = hard_scenes(settings.seed);
    for (const HardScene &scene : scenes) {
        const Scene brute(scene.triangles);
        std::vector<Asked> asked(ray_kinds.size() * chunks);
        parallel_for(asked.size(), [&](std::size_t i) {
            const RayKind &kind = ray_kinds[i / chunks];
            const std::size_t first = i % chunks * chunk_size, count = std::min(chunk_size, cases - first);
            asked[i] = ask_brute_force(scene, brute, kind, stream_of(scene.name + kind.name, settings.seed) + i, count);
        });
        for (const NamedStructure &structure : all_structures()) {
            const auto built = structure.around(scene.triangles);
            std::vector<std::atomic<std::uint64_t>> wrong(ray_kinds.size());
            parallel_for(asked.size(), [&](std::size_t i) {
                wrong[i / chunks] += disagreements(asked[i], *built, ray_kinds[i / chunks].shadow);
            });
            for (std::size_t k = 0; k < ray_kinds.size(); ++k)
                close_row(outcome,
                          result_row("H12", "soup", structure.name, true, "double",
                                     scene.name + ", " + ray_kinds[k].name, settings),
                          cases, wrong[k], 0, true);
            settings.done(1.0 / static_cast<double>(scenes.size() * all_structures().size()));
        }
    }
    return outcome;
}

} // namespace

Suite structure_suite() { return {"structures", {"H12"}, agreement, 4}; }

} // namespace course::hard
