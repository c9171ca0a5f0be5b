// Grades exercise 13: on which sides of a plane is a ray, and in what order?
#include "exercises/13_bsp_sides/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <cmath>

namespace course {

namespace {

std::string text(const Sides &sides) {
    return std::string(sides.first_above ? "above" : "below") +
           (sides.both ? (sides.first_above ? ", then below" : ", then above") : " alone");
}

// Where the ray begins and ends, told by the sign of n . p - offset. All numbers here are small whole numbers or
// halves of such, so nothing is rounded.
double height(const Vec<double> &p, const CutPlane &plane) { return dot(plane.normal, p) - plane.offset; }

// A ray that begins above and ends below has been on both sides. Asks only where neither end lies in the plane.
void ask(Check &check, const Task &task, const Ray<double> &ray, const CutPlane &plane) {
    const double begin = height(point_at(ray, ray.t_min), plane);
    const double slope = dot(plane.normal, ray.direction);
    const double end = std::isinf(ray.t_max) ? (slope != 0 ? slope : begin) : height(point_at(ray, ray.t_max), plane);
    if (begin == 0 || end == 0)
        return;
    check.given({{"ray", ray}, {"plane's normal", plane.normal}, {"offset", plane.offset}, {"t_max", ray.t_max}});
    const Sides expected{begin > 0, (begin > 0) != (end > 0), 0};
    const Sides yours = task.sides_met(ray, plane);
    check.that(yours.first_above == expected.first_above && yours.both == expected.both, text(expected), text(yours));
    if (expected.both)
        check.hit(yours.change,
                  exact::plane(ray, plane.normal * (plane.offset / dot(plane.normal, plane.normal)), plane.normal),
                  1e6);
}

Vec<double> whole_point(Random &random, int most) {
    const auto one = [&] {
        return static_cast<double>(static_cast<int>(random.bits() % unsigned(2 * most + 1)) - most);
    };
    return {one(), one(), one()};
}

CutPlane any_plane(Random &random) {
    Vec<double> normal = whole_point(random, 2);
    if (normal == Vec<double>(0))
        normal = {1, 2, -2};
    return {normal, static_cast<double>(random.bits() % 5) - 2};
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "13_bsp_tree", "The walk: cutting an interval"};
    };

    grading.check(question("a ray that crosses the plane is first on the side where it begins",
                           "The side of a point is the sign of normal · p - offset. Which side comes first depends on "
                           "where the ray begins, not on where it is going."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(1, i);
                          const CutPlane plane = any_plane(random);
                          const Ray<double> ray{whole_point(random, 5), whole_point(random, 3)};
                          if (height(ray.origin, plane) * dot(plane.normal, ray.direction) < 0)
                              ask(check, task, ray, plane);
                      }
                  });

    grading.check(question("a ray that runs away from the plane stays on its side",
                           "It would meet the plane at a negative t. That is behind it."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(2, i);
                          const CutPlane plane = any_plane(random);
                          const Ray<double> ray{whole_point(random, 5), whole_point(random, 3)};
                          if (height(ray.origin, plane) * dot(plane.normal, ray.direction) > 0)
                              ask(check, task, ray, plane);
                      }
                  });

    grading.check(
        question("a ray parallel to the plane stays on its side",
                 "normal · d is 0 there, and dividing by it gives an infinity, or NaN. No change of sides, then."),
        [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(3, i);
                const CutPlane plane = any_plane(random);
                Vec<double> along = cross(plane.normal, whole_point(random, 2));
                ask(check, task, {whole_point(random, 5), along}, plane);
                ask(check, task, {whole_point(random, 5), along, 0, 9}, plane);
            }
        });

    grading.check(
        question("the ray's interval is all that counts",
                 "A ray that ends before it reaches the plane, because a hit has been found or the light is "
                 "there, does not visit the other side; nor one that begins (at t_min) behind it."),
        [&](Check &check) {
            for (unsigned i = 0; i < 600; ++i) {
                Random random(4, i);
                const double t_min = 0.5 * (random.bits() % 4), t_max = t_min + 0.5 * (1 + random.bits() % 8);
                ask(check, task, {whole_point(random, 5), whole_point(random, 3), t_min, t_max}, any_plane(random));
            }
        });

    grading.check(
        question("a ray that begins in the plane visits the side it goes to",
                 "It is on neither side at its origin, so its direction decides; the other side would be a visit "
                 "for nothing, but the one it goes to must not be lost."),
        [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(5, i);
                const CutPlane plane = any_plane(random);
                const Vec<double> direction = whole_point(random, 3);
                const double slope = dot(plane.normal, direction);
                const Vec<double> origin = whole_point(random, 5);
                if (slope == 0 || height(origin, plane) != 0)
                    continue;
                check.given({{"origin", origin},
                             {"direction", direction},
                             {"plane's normal", plane.normal},
                             {"offset", plane.offset}});
                const Sides yours = task.sides_met({origin, direction}, plane);
                check.that(yours.first_above == (slope > 0) || yours.both,
                           slope > 0 ? "the side above is visited" : "the side below is visited", text(yours));
            }
        });
}

} // namespace course
