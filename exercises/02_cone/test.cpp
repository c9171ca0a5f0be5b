// Grades exercise 02: the side of a cone.
#include "exercises/02_cone/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"
#include "tests/oracle/shapes.hpp"

namespace course {

namespace {

constexpr double allowed = 0x1p22; // ulp: the discriminant of a ray that grazes the side cancels

Cone<float> any_cone(Random &random) {
    const Vec<double> apex = any_point(random, 2), axis = random.uniform(0.5, 2) * any_direction(random);
    return {Vec<float>(apex), Vec<float>(apex + axis), static_cast<float>(random.uniform(0.4, 1.5))};
}

// A point at this height above the apex (1: at the base), so many cone's radii from the axis.
Vec<double> place(const Cone<float> &cone, double height, double aside, Random &random) {
    const Vec<double> apex(cone.apex), axis = Vec<double>(cone.base) - apex;
    const Vec<double> out = normalize(cross(axis, any_direction(random)));
    return apex + height * axis + height * aside * static_cast<double>(cone.radius) * out;
}

void ask(Check &check, const Task &task, const Ray<double> &ray, const Cone<float> &cone) {
    check.given({{"ray", ray}, {"apex", cone.apex}, {"base", cone.base}, {"radius", cone.radius}});
    check.hit(task.cone_hit(ray, cone), exact::answer(ray, cone), allowed);
}

// Rays from one place to another, in a direction of any length.
void from_to(Check &check, const Task &task, std::uint64_t seed, auto from, auto to) {
    for (unsigned i = 0; i < 300; ++i) {
        Random random(seed, i);
        const Cone<float> cone = any_cone(random);
        const Vec<double> origin = from(cone, random);
        ask(check, task, {origin, random.uniform(0.3, 2) * (to(cone, random) - origin)}, cone);
    }
}

Vec<double> inside(const Cone<float> &cone, Random &random) {
    return place(cone, random.uniform(0.2, 0.9), random.uniform(0, 0.9), random);
}
Vec<double> far_away(const Cone<float> &cone, Random &random) {
    return Vec<double>(cone.apex) + 5. * any_direction(random);
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("02_primitives");
    const char *const lesson = "The cone, and its mirror image";

    grading.check(
        "a ray across the axis",
        "The distance of a point from the axis, |p x n| / |n|, is the height p · n / |n| times r / |n|. Square it, "
        "put the ray in, and sort by powers of t.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(1, i);
                const Cone<float> cone{{0, 0, 0}, {0, 0, 2}, static_cast<float>(random.uniform(0.5, 2))};
                const double z = random.uniform(0.2, 3), angle = random.uniform(0, 6.28);
                const Vec<double> d(std::cos(angle), std::sin(angle), 0);
                ask(check, task, {Vec<double>(0, 0, z) - 5. * d + random.uniform(0, 1) * Vec<double>(d.y, -d.x, 0), d},
                    cone);
            }
        });

    grading.check(
        "a slanted ray",
        "Across the axis d · n is 0, and there it does not show whether it should be squared. Turn the ray around: "
        "-d and -t are the same line, so a = (d · n)² - cos² |d|² must not change its value. The notes print d · n "
        "without the square.",
        lesson, [&](Check &check) {
            from_to(
                check, task, 2,
                [](const Cone<float> &cone, Random &random) {
                    return place(cone, random.uniform(0.2, 0.8), 8, random);
                },
                inside);
        });

    grading.check(
        "from inside, and through the open base",
        "The side has no lid: a ray may come in through the base, and one that starts inside has its near root behind "
        "it. Try both roots, the smaller one first.",
        "The roots", [&](Check &check) {
            from_to(check, task, 3, inside, [](const Cone<float> &cone, Random &random) {
                return place(cone, random.uniform(0.2, 0.9), 1, random);
            });
        });

    grading.check(
        "the mirror image is not met",
        "Squaring has added a second cone on the other side of the apex, where p · n is negative. A root there does "
        "not count.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(5, i);
                const Cone<float> cone = any_cone(random);
                const Vec<double> origin = place(cone, random.uniform(-0.9, -0.5), 2, random);
                const Vec<double> target = place(cone, random.uniform(-0.9, -0.5), random.uniform(0, 0.9), random);
                const Ray<double> ray{origin, target - origin};
                if (!exact::answer(ray, cone).may_hit()) // else the cone itself is met later
                    ask(check, task, ray, cone);
            }
        });

    grading.check(
        "the mirror image hides nothing",
        "A ray steeper than the side meets both cones once, and the mirror image may come first. Look at each root's "
        "height before the nearest is chosen, not afterwards.",
        lesson, [&](Check &check) {
            from_to(
                check, task, 6,
                [](const Cone<float> &cone, Random &random) {
                    return place(cone, random.uniform(-1.5, -1), random.uniform(0, 0.5), random);
                },
                [](const Cone<float> &cone, Random &random) {
                    return place(cone, random.uniform(0.3, 0.6), 1, random);
                });
        });

    grading.check("beyond the base there is no side",
                  "The height p · n runs from 0 at the apex to |n|² at the rim; p = o + t d - apex.", lesson,
                  [&](Check &check) {
                      from_to(check, task, 4, far_away, [](const Cone<float> &cone, Random &random) {
                          return place(cone, random.uniform(1.1, 2), random.uniform(0, 0.9), random);
                      });
                  });

    grading.check(
        "a ray along the side: the equation is linear",
        "A direction parallel to a line of the side makes a = 0. Then q / a is infinite or NaN, and c / q is the only "
        "solution.",
        "The roots", [&](Check &check) {
            const Cone<float> cone{{0, 0, 0}, {0, 0, 4}, 4}; // whole numbers, so that a is exactly 0
            for (const double x : {-1., -2., -3., 1., 2., 3.})
                for (const double y : {0., 1.}) {
                    ask(check, task, {{x, y, 0}, {1, 0, 1}}, cone);
                    ask(check, task, {{x, y, 5}, {2, 0, -2}}, cone);
                }
        });

    grading.check(
        "the apex belongs to the cone",
        "The height is exactly 0 there, and so is the discriminant. Strict comparisons leave a hole in the tip.",
        lesson, [&](Check &check) {
            const Cone<float> cone{{0, 0, 0}, {0, 0, 4}, 4};
            for (const Vec<double> &d : {Vec<double>(1, 0, 0), {0, -2, 0}, {4, 1, 0}})
                ask(check, task, {-3. * d, d}, cone);
        });
}

} // namespace course
