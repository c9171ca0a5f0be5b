// Grades exercise 03: a ray that leaves a surface and neither sticks nor leaks.
#include "exercises/03_spawn_offset/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"
#include "tests/oracle/shapes.hpp"

namespace course {

namespace {

// A place on a sphere as a hit leaves it: worked out in double, and so a few roundings off the surface.
struct Exit {
    Sphere<float> sphere;
    Vec<double> point, normal, aside;
};

Exit any_exit(Random &random, double scale, double away) {
    const auto centre = Vec<float>(scale * away * any_direction(random));
    const Sphere<float> sphere{centre, static_cast<float>(scale * random.uniform(0.5, 1))};
    const Vec<double> normal = any_direction(random);
    return {sphere, Vec<double>(centre) + static_cast<double>(sphere.radius) * normal, normal,
            normalize(cross(normal, any_direction(random)))};
}

// Leaves at this height over the surface: 1 straight up, 0 along it, negative inwards.
Ray<double> ask(Check &check, const Task &task, const Exit &exit, double cosine) {
    const Vec<double> direction = cosine * exit.normal + std::sqrt(1 - cosine * cosine) * exit.aside;
    check.given({{"point", exit.point},
                 {"normal", exit.normal},
                 {"direction", direction},
                 {"centre", exit.sphere.centre},
                 {"radius", exit.sphere.radius}});
    return task.leaving(exit.point, exit.normal, direction, exit.sphere);
}

void outwards(Check &check, const Task &task, const Exit &exit, double cosine) {
    const Ray<double> ray = ask(check, task, exit, cosine);
    const auto answer = exact::answer(ray, exit.sphere);
    if (answer.may_hit())
        check.fail("no hit with the sphere that it leaves",
                   "it is met again; your ray starts at " + in_words(ray.origin));
    ++check.asked;
}

void inwards(Check &check, const Task &task, const Exit &exit, double cosine) {
    const Ray<double> ray = ask(check, task, exit, cosine);
    const auto answer = exact::answer(ray, exit.sphere);
    if (!answer.may_hit() || answer.t < std::abs(cosine) * static_cast<double>(exit.sphere.radius))
        check.fail("the far side is the first thing met",
                   answer.may_hit() ? "the near side is met at once" : "nothing is met: the ray starts outside");
    ++check.asked;
}

// A wall a little way above the point must be met.
void wall_above(Check &check, const Task &task, const Exit &exit, double gap) {
    const Ray<double> ray = ask(check, task, exit, 0.8);
    const Vec<double> wall = exit.point + gap * static_cast<double>(exit.sphere.radius) * exit.normal;
    check.that(exact::plane(ray, wall, exit.normal).may_hit(),
               "a wall " + in_words(gap) + " radii above the point is met", "your ray starts behind it");
}

void for_exits(std::uint64_t seed, double scale, double away, auto visit) {
    for (unsigned i = 0; i < 100; ++i) {
        Random random(seed, i);
        visit(any_exit(random, scale, away), random.uniform(0.1, 1));
    }
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("03_light_and_shadow");
    const char *const lesson = "Neither stick nor leak";

    grading.check("the direction stays as it is", "Only the origin moves. The ray has no end: t from 0 to infinity.",
                  lesson, [&](Check &check) {
                      for_exits(1, 1, 2, [&](const Exit &exit, double cosine) {
                          const Ray<double> ray = ask(check, task, exit, cosine);
                          check.vector("direction", ray.direction,
                                       cosine * exit.normal + std::sqrt(1 - cosine * cosine) * exit.aside);
                          check.that(ray.t_min <= 1e-9 && ray.t_max == infinity<double>, "0 < t",
                                     "t from " + in_words(ray.t_min) + " to " + in_words(ray.t_max));
                      });
                  });

    grading.check(
        "a ray that leaves does not meet its own sphere",
        "The point is rounded, so it lies a hair above the surface or a hair below it, and from below the ray meets "
        "the "
        "surface that it leaves: shadow acne. Move the origin along the normal by more than that hair, and keep it "
        "in double.",
        "Where does the new ray start?", [&](Check &check) {
            for_exits(2, 1, 2, [&](const Exit &exit, double cosine) { outwards(check, task, exit, cosine); });
        });

    grading.check("a ray that goes in meets the far side",
                  "Glass sends rays inwards. Move the origin to the side to which the ray goes.", lesson,
                  [&](Check &check) {
                      for_exits(3, 1, 2, [&](const Exit &exit, double cosine) { inwards(check, task, exit, -cosine); });
                  });

    grading.check(
        "a ray that leaves flat",
        "A step along a flat ray gains no height. Step along the normal: beyond the tangent plane a ray that does not "
        "go down never meets a sphere again, however flat it is.",
        lesson, [&](Check &check) {
            for (const double cosine : {1e-2, 1e-4, 1e-7})
                for_exits(4, 1, 2, [&](const Exit &exit, double) {
                    outwards(check, task, exit, cosine);
                    inwards(check, task, exit, -cosine);
                });
        });

    grading.check(
        "nothing that stands close by is stepped over",
        "An offset that is larger than it need be carries the ray through a thin gap, and light leaks in. How far can "
        "the point really be off? A few roundings of 2^-53, not a thousandth of anything.",
        lesson, [&](Check &check) {
            for (const double gap : {1e-2, 1e-4, 1e-6})
                for_exits(5, 1, 2, [&](const Exit &exit, double) { wall_above(check, task, exit, gap); });
        });

    grading.check(
        "at every scale",
        "The error of the point is a rounding of the numbers that went into it, so it grows with them: with the "
        "coordinates of the point and of the centre, and with the radius. No constant fits a planet and a teacup.",
        lesson, [&](Check &check) {
            for (const double scale : {1e-3, 1e3, 1e6})
                for (const double away : {2., 100.})
                    for_exits(6, scale, away, [&](const Exit &exit, double cosine) {
                        outwards(check, task, exit, cosine);
                        inwards(check, task, exit, -cosine);
                        outwards(check, task, exit, 1e-6);
                        wall_above(check, task, exit, 1e-6);
                    });
        });
}

} // namespace course
