// Grades exercise 17, the second: a walk through a BVH in GLSL.
#include "exercises/17_traversal_stack/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/shader_runs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace course {

namespace {

constexpr int rays = 256;

// What the learner is given; README.md says what each does.
const std::string given = R"(
vec3 origin, direction;
float t_max = 1.0 / 0.0;
float boxes = 0, spheres = 0;
vec4 lo(int node) { return texelFetch(cases, 2 * node); }
vec4 hi(int node) { return texelFetch(cases, 2 * node + 1); }
bool is_leaf(int node) { return lo(node).w < 0; }
int first_child(int node) { return int(lo(node).w); }
int second_child(int node) { return int(hi(node).w); }
float enters(int node) {
    ++boxes;
    vec3 a = (lo(node).xyz - origin) / direction, b = (hi(node).xyz - origin) / direction;
    vec3 near = min(a, b), far = max(a, b);
    float enter = max(max(near.x, near.y), max(near.z, 0.0)), leave = min(min(far.x, far.y), min(far.z, t_max));
    return enter <= leave ? enter : -1.0;
}
float sphere(int leaf) {
    vec3 centre = 0.5 * (lo(leaf).xyz + hi(leaf).xyz), to_centre = centre - origin, miss = cross(to_centre, direction);
    float a = dot(direction, direction), b = dot(to_centre, direction), radius = hi(leaf).w;
    float discriminant = radius * radius * a - dot(miss, miss);
    float t = (b - sqrt(max(discriminant, 0.0))) / a;
    return discriminant >= 0 && t > 0 ? t : -1.0;
}
float hit(int leaf) {
    ++spheres;
    float t = sphere(leaf);
    return t < t_max ? t : -1.0;
}
)";

// Asks the learner's walk, then every leaf, with the very same tests.
const std::string ask_both = R"(void main() {
    int at = 2 * NODES + 2 * int(gl_FragCoord.x);
    origin = texelFetch(cases, at).xyz;
    direction = texelFetch(cases, at + 1).xyz;
    float yours = nearest(), all = -1.0;
    for (int node = 0; node < NODES; ++node)
        if (is_leaf(node)) {
            float t = sphere(node);
            all = t > 0 && (all < 0 || t < all) ? t : all;
        }
    result = vec4(yours, all, boxes, spheres);
})";

struct Built {
    std::vector<Texel> nodes; // two for each: lo and first child (-1: a leaf), hi and second child or radius
    int depth = 0;
};

int build(Built &tree, std::span<Sphere<float>> spheres, int depth) {
    Vec<float> lo(infinity<float>), hi(-infinity<float>);
    for (const auto &[centre, radius] : spheres) {
        lo = min(lo, centre - radius);
        hi = max(hi, centre + radius);
    }
    const std::size_t at = tree.nodes.size();
    tree.depth = std::max(tree.depth, depth);
    tree.nodes.push_back({lo.x, lo.y, lo.z, -1});
    tree.nodes.push_back({hi.x, hi.y, hi.z, spheres[0].radius});
    if (spheres.size() > 1) {
        const Vec<float> e = hi - lo;
        const int axis = e.x >= e.y ? (e.x >= e.z ? 0 : 2) : (e.y >= e.z ? 1 : 2);
        std::ranges::sort(spheres, {}, [&](const Sphere<float> &s) { return s.centre[axis]; });
        const std::size_t half = spheres.size() / 2;
        const int first = build(tree, spheres.first(half), depth + 1);
        const int second = build(tree, spheres.subspan(half), depth + 1);
        tree.nodes[at][3] = static_cast<float>(first);
        tree.nodes[at + 1][3] = static_cast<float>(second);
    }
    return static_cast<int>(at / 2);
}

// A block of spheres, and rays through it: a result for each of the rays.
std::vector<Texel> walked(Check &check, const Task &task, std::size_t count) {
    std::vector<Sphere<float>> spheres;
    const double radius = 1.2 / std::cbrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        Random random(count, i);
        spheres.push_back({Vec<float>(any_point(random, 1)), static_cast<float>(radius * random.uniform(0.3, 1))});
    }
    Built tree;
    build(tree, spheres, 1);
    std::vector<Texel> texels = tree.nodes;
    for (unsigned i = 0; i < rays; ++i) {
        Random random(2, i);
        const Vec<float> origin(3. * any_direction(random));
        const Vec<float> along = Vec<float>(any_point(random, 1)) - origin;
        texels.push_back({origin.x, origin.y, origin.z, 0});
        texels.push_back({along.x, along.y, along.z, 0});
    }
    check.given({{"spheres", count}, {"rays", rays}});
    const std::string defines = "#define DEPTH " + std::to_string(tree.depth + 1) + "\n#define NODES " +
                                std::to_string(tree.nodes.size() / 2) + "\n";
    return run_answer(check, task, defines + given, ask_both, texels, rays);
}

std::size_t sum(const std::vector<Texel> &results, std::size_t component) {
    float all = 0;
    for (const Texel &result : results)
        all += result[component];
    return static_cast<std::size_t>(all);
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) { return Question{name, why, "17_gpu", "Meshes"}; };

    grading.check(
        question("the nearest hit is found, the same as by asking every sphere",
                 "A node that is met waits on the stack until its turn comes; none may be overwritten or left "
                 "there. A hit in one child says nothing about the other, whose box may begin before it."),
        [&](Check &check) {
            for (const std::size_t count : {1, 2, 5, 60, 400})
                for (const auto &[yours, all, boxes, spheres] : walked(check, task, count))
                    check.that(yours == all, "t = " + std::to_string(all), "t = " + std::to_string(yours));
        });

    grading.check(
        question("what lies behind the hit is left alone",
                 "Set t_max to each hit that you find: enters() and hit() then say no to all that lies behind it."),
        [&](Check &check) {
            const auto results = walked(check, task, 2048);
            check.at_most("how many spheres are tested in all", sum(results, 3), 1800);
        });

    grading.check(
        question("the nearer child is visited first",
                 "Of two children that are met, put the farther one on the stack first, so that the nearer one is "
                 "taken first. The sooner a near hit is found, the more lies behind it."),
        [&](Check &check) {
            const auto results = walked(check, task, 2048);
            check.at_most("how many boxes are asked in all", sum(results, 2), 14500);
        });
}

} // namespace course
