// Lesson 08, the experiment: rays from inside a closed mesh, and what each form of the triangle test makes of them.
#pragma once
#include "chapters/08_mesh/ball.hpp"
#include "chapters/08_mesh/forms.hpp"

#include <string>

namespace course {

// Rays from inside a closed mesh, of which each must meet an odd number of triangles.
struct Family {
    std::string name;
    Mesh<> mesh;
    std::vector<Ray<float>> rays;
};

inline std::vector<Family> leak_families(std::uint64_t seed, int count = 40000) {
    Random random(seed);
    std::vector<Family> families{
        {"face", ball(2), {}}, {"edge", ball(2), {}}, {"corner", ball(2), {}}, {"lattice", ball(2, 8), {}}};
    for (int i = 0; i < count; ++i) {
        const Triangle<> t = triangle(families[0].mesh, random.bits() % size(families[0].mesh));
        const Vec<double> a(t.a), b(t.b), c(t.c), from = in_ball(random, 0.7);
        const double u = random.uniform(), v = (1 - u) * random.uniform();
        families[0].rays.push_back(ray_through(from, a + u * (b - a) + v * (c - a)));
        families[1].rays.push_back(ray_through(from, a + u * (b - a)));
        families[2].rays.push_back(ray_through(from, a));
    }
    // Corners on whole numbers, and rays along the axes from halves and wholes: edges are hit exactly, again and again.
    for (Vec<float> &point : families[3].mesh.points)
        point = round(point);
    for (int i = 0; i < count; ++i) {
        Ray<float> ray{Vec<float>(round(in_ball(random, 8))) * 0.5f, Vec<float>(0)};
        ray.direction[static_cast<int>(random.bits() % 3)] = random.bits() % 2 ? 1.0f : -1.0f;
        families[3].rays.push_back(ray);
    }
    return families;
}

// How many of a million rays meet no triangle, and how many an even number of them.
struct Losses {
    double leaks = 0, even = 0;
};
template <class PrepareRay, class PrepareTriangle, class Test>
Losses losses_of(const Family &family, PrepareRay prepare_ray, PrepareTriangle prepare_triangle, Test test) {
    std::vector<decltype(prepare_triangle(triangle(family.mesh, 0)))> prepared;
    for (Id id = 0; id < size(family.mesh); ++id)
        prepared.push_back(prepare_triangle(triangle(family.mesh, id)));
    double leaks = 0, even = 0;
    for (const Ray<float> &plain : family.rays) {
        const auto ray = prepare_ray(plain);
        const auto hits = std::ranges::count_if(prepared, [&](const auto &t) { return test(ray, t).has_value(); });
        leaks += hits == 0;
        even += hits % 2 == 0;
    }
    const double million = 1e6 / static_cast<double>(family.rays.size());
    return {million * leaks, million * even};
}

} // namespace course
