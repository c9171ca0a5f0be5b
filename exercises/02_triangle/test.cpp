// Grades exercise 02: a triangle with its division done in advance.
#include "exercises/02_triangle/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <array>

namespace course {

namespace {

using Corners = std::array<Vec<float>, 3>;
using exact::Answer;
using exact::Verdict;

void ask(Check &check, const Task &task, const Ray<double> &ray, const Corners &corners, const Answer &expected) {
    const auto &[a, b, c] = corners;
    check.given({{"ray", ray}, {"a", a}, {"b", b}, {"c", c}});
    check.hit(task.triangle_hit(ray, task.make_ready(a, b, c)), expected, 0x1p16);
}

Answer exact_answer(const Ray<double> &ray, const Corners &corners) {
    return exact::triangle(ray, Vec<double>(corners[0]), Vec<double>(corners[1]), Vec<double>(corners[2]));
}

Vec<double> place(const Corners &corners, double u, double v) {
    const Vec<double> a(corners[0]);
    return a + u * (Vec<double>(corners[1]) - a) + v * (Vec<double>(corners[2]) - a);
}

// Of a moderate shape: no needle.
Corners any_triangle(Random &random, double size) {
    for (;;) {
        const Vec<double> a = any_point(random, 1), b = any_point(random, 1), c = any_point(random, 1);
        if (length(cross(b - a, c - a)) > 0.3)
            return {Vec<float>(size * a), Vec<float>(size * b), Vec<float>(size * c)};
    }
}

// A ray to the place (u, v), from either side, with a direction of any length.
Ray<double> ray_to(const Corners &corners, double u, double v, Random &random, double size) {
    const Vec<double> n = normalize(cross(Vec<double>(corners[1] - corners[0]), Vec<double>(corners[2] - corners[0])));
    const double side = random.uniform() < 0.5 ? -1 : 1;
    const Vec<double> target = place(corners, u, v), away = side * n + 0.9 * any_direction(random);
    return {target + random.uniform(1, 3) * size * away, -random.uniform(0.2, 3) * size * away};
}

void through_and_beside(Check &check, const Task &task, double size, std::uint64_t seed) {
    for (unsigned i = 0; i < 300; ++i) {
        Random random(seed, i);
        const Corners corners = any_triangle(random, size);
        const double u = random.uniform(-0.5, 1.5), v = random.uniform(-0.5, 1.5);
        if (std::min({std::abs(u), std::abs(v), std::abs(1 - u - v)}) < 0.01)
            continue; // too close to an edge to be told without exact arithmetic
        const Ray<double> ray = ray_to(corners, u, v, random, size);
        ask(check, task, ray, corners, exact_answer(ray, corners));
    }
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("02_primitives");
    const char *const lesson = "The triangle, with its division done in advance";

    grading.check(
        "k1 and k2 read off u and v",
        "With p = a + u e1 + v e2, k1 · (p - a) must be u: so k1 · e1 = 1 and k1 · e2 = 0, and k1 lies in the "
        "triangle's plane. Perpendicular to e2 and in the plane is e2 x N; divide it by what it gives with e1.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(1, i);
                const Corners corners = any_triangle(random, 1);
                const auto &[a, b, c] = corners;
                const ReadyTriangle ready = task.make_ready(a, b, c);
                const double u = random.uniform(0.5, 1), v = random.uniform(0.5, 1);
                const Vec<double> n = cross(Vec<double>(b) - Vec<double>(a), Vec<double>(c) - Vec<double>(a));
                const Vec<double> p = place(corners, u, v) + random.uniform(-1, 1) * normalize(n);
                check.given({{"a", a}, {"b", b}, {"c", c}, {"p", p}});
                check.number("k1 · (p - a)", dot(ready.k1, p - Vec<double>(a)), u, 4096);
                check.number("k2 · (p - a)", dot(ready.k2, p - Vec<double>(a)), v, 4096);
            }
        });

    grading.check(
        "rays through the triangle meet it, rays beside it do not",
        "t is where the ray meets the plane, n · (a - o) / n · d. The point there is inside when u, v and 1 - u - v "
        "are all at least 0: three edges, three conditions. Both sides of a triangle count.",
        lesson, [&](Check &check) { through_and_beside(check, task, 1, 2); });

    grading.check(
        "a hit counts only inside the ray's interval",
        "A triangle behind the origin, or beyond t_max, is not met: in_range(ray, t) says it.", "The plane",
        [&](Check &check) {
            const Corners corners{Vec<float>(0, 0, 0), Vec<float>(4, 0, 0), Vec<float>(0, 4, 0)};
            for (const auto &[t_min, t_max] : {std::pair{0., 9.}, {2., 9.}, {0., 2.}, {2.5, 9.}, {0., 1.5}}) {
                const Ray<double> down{{1, 1, 2}, {0, 0, -1}, t_min, t_max}, up{{1, 1, 2}, {0, 0, 1}, t_min, t_max};
                ask(check, task, down, corners, exact_answer(down, corners));
                ask(check, task, up, corners, {});
            }
        });

    grading.check(
        "an edge and a corner belong to the triangle",
        "Here all numbers are whole, so u, v or 1 - u - v is exactly 0 on an edge. With > in place of >= a ray "
        "through an edge that two triangles share hits neither, and one sees through the surface.",
        lesson, [&](Check &check) {
            const Corners corners{Vec<float>(0, 0, 0), Vec<float>(4, 0, 0), Vec<float>(0, 4, 0)};
            for (const auto &[x, y] : {std::pair{0., 0.}, {4., 0.}, {0., 4.}, {2., 0.}, {0., 1.}, {1., 3.}})
                for (const double side : {-1., 1.})
                    ask(check, task, {{x, y, 2 * side}, {0, 0, -side}}, corners, {Verdict::hit, 2});
        });

    grading.check(
        "the size of the scene does not matter",
        "n · d is small when the triangle or the direction is small, not only when the ray runs along the plane. No "
        "constant can tell the two apart, and none is needed: along the plane t is infinite or NaN, and no "
        "interval contains it.",
        "The plane", [&](Check &check) {
            through_and_beside(check, task, 1e-4, 5);
            through_and_beside(check, task, 1e5, 6);
        });

    grading.check(
        "a ray along the plane, or a triangle without area: no hit",
        "t is 0 / 0 or infinite here. Every comparison with NaN is false, so write conditions that accept, and not "
        "ones that reject.",
        "The plane", [&](Check &check) {
            const Corners corners{Vec<float>(0, 0, 0), Vec<float>(4, 0, 0), Vec<float>(0, 4, 0)};
            ask(check, task, {{-1, 1, 0}, {1, 0, 0}}, corners, {});
            ask(check, task, {{-1, 1, 1}, {1, 0, 0}}, corners, {});
            ask(check, task, {{1, 1, 2}, {0, 0, 0}}, corners, {});
            ask(check, task, {{1, 1, 2}, {0, 0, -1}}, {corners[0], corners[1], corners[1]}, {});
            ask(check, task, {{0, 0, 2}, {0, 0, -1}}, {corners[0], corners[0], corners[0]}, {});
        });
}

} // namespace course
