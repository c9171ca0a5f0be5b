// Lesson 08, the experiment: the triangle test in its forms, and what each takes.
#pragma once
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/08_mesh/moller_trumbore.hpp"
#include "common/random.hpp"
#include "common/timing.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace course {

// A ray whose numbers are floats, so that every form is asked about the very same ray.
inline Ray<float> ray_through(const Vec<double> &from, const Vec<double> &to) {
    const Vec<float> origin(from);
    return {origin, Vec<float>(to - Vec<double>(origin))};
}

inline Vec<double> in_ball(Random &random, double radius) {
    while (true) {
        const Vec<double> p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (dot(p, p) < 1)
            return radius * p;
    }
}

// Calls visit(name, name in a plot, scalar, prepare_ray, prepare_triangle, test) for every form.
template <class Visit> void for_each_form(Visit visit) {
    const auto as_it_is = [](const auto &x) { return x; };
    const auto widened = [](const Ray<float> &ray) {
        return Ray<double>{Vec<double>(ray.origin), Vec<double>(ray.direction)};
    };
    const auto sheared = [=](const Ray<float> &ray) { return with_shear(widened(ray)); };
    const auto affine = [](const Triangle<> &t) { return affine_triangle(t.a, t.b, t.c); };
    const auto textbook = [](const auto &r, const auto &t) { return intersect_textbook(r, t); };
    const auto strict = [](const auto &r, const auto &t) { return moller_trumbore_strict(r, t); };
    const auto inclusive = [](const auto &r, const auto &t) { return moller_trumbore(r, t); };
    const auto standard = [](const auto &r, const auto &t) { return intersect(r, t); };
    visit("affine, k1 k2 stored (note A)", "affine, float", "float", as_it_is, affine, textbook);
    visit("affine, k1 k2 stored", "affine, double", "double inside", widened, affine, standard);
    visit("Möller-Trumbore, strict (notes B, C)", "strict, float", "float", as_it_is, as_it_is, strict);
    visit("Möller-Trumbore, with edges", "edges, float", "float", as_it_is, as_it_is, inclusive);
    visit("Möller-Trumbore, with edges", "edges, double", "double", widened, as_it_is, inclusive);
    visit("watertight", "watertight", "double inside", widened, as_it_is, standard);
    visit("watertight, shear made once a ray", "prepared", "double inside", sheared, as_it_is, standard);
}

// A ray and a triangle each: about half are hits, in no order that a processor could learn.
struct Pairs {
    std::vector<Ray<float>> rays;
    std::vector<Triangle<>> triangles;
};
inline Pairs random_pairs(std::uint64_t seed, std::size_t count) {
    Random random(seed);
    Pairs pairs;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle<> t{Vec<float>(in_ball(random, 1)), Vec<float>(in_ball(random, 1)),
                           Vec<float>(in_ball(random, 1))};
        const Vec<double> a(t.a), b(t.b), c(t.c);
        const double u = random.uniform(), v = random.uniform(); // half of the parallelogram a, b, a + b - c, c
        pairs.rays.push_back(ray_through(in_ball(random, 3), a + u * (b - a) + v * (c - a)));
        pairs.triangles.push_back(t);
    }
    return pairs;
}

// The loop over all pairs to be timed, one after the other and `repeats` times over; rays and triangles are prepared
// before.
template <class PrepareRay, class PrepareTriangle, class Test> std::function<void()>
loop_over(const Pairs &pairs, int repeats, PrepareRay prepare_ray, PrepareTriangle prepare_triangle, Test test) {
    std::vector<decltype(prepare_ray(pairs.rays[0]))> rays;
    std::vector<decltype(prepare_triangle(pairs.triangles[0]))> triangles;
    std::ranges::transform(pairs.rays, std::back_inserter(rays), prepare_ray);
    std::ranges::transform(pairs.triangles, std::back_inserter(triangles), prepare_triangle);
    return [rays = std::move(rays), triangles = std::move(triangles), repeats, test] {
        double sum = 0;
        for (int repeat = 0; repeat < repeats; ++repeat)
            for (std::size_t i = 0; i < rays.size(); ++i)
                if (const auto t = test(rays[i], triangles[i]))
                    sum += static_cast<double>(*t);
        keep(sum);
    };
}

inline std::vector<double> nanoseconds_per_test(std::uint64_t seed) {
    constexpr int count = 8192, repeats = 20;
    const Pairs pairs = random_pairs(seed, count);
    std::vector<std::function<void()>> variants;
    for_each_form([&](const char *, const char *, const char *, auto prepare_ray, auto prepare_triangle, auto test) {
        variants.push_back(loop_over(pairs, repeats, prepare_ray, prepare_triangle, test));
    });
    std::vector<double> times = median_seconds(variants, 15);
    for (double &time : times)
        time *= 1e9 / (count * repeats);
    return times;
}

} // namespace course
