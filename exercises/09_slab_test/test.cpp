// Grades exercise 09: does a ray pass through a box?
#include "exercises/09_slab_test/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"
#include "tests/oracle/shapes.hpp"

namespace course {

namespace {

Box<float> any_box(Random &random) {
    const Vec<float> middle(any_point(random, 2));
    const Vec<float> half(abs(any_point(random, 1)) + 0.1);
    return {middle - half, middle + half};
}

Box<float> grown(const Box<float> &box, float by) { return {box.lo - by, box.hi + by}; }

bool holds(const Box<float> &box, const Vec<double> &p) {
    const Vec<double> lo(box.lo), hi(box.hi);
    return p.x >= lo.x && p.y >= lo.y && p.z >= lo.z && p.x <= hi.x && p.y <= hi.y && p.z <= hi.z;
}

// The oracle tells where a ray crosses the surface; one that begins and ends inside crosses nothing, but is in the box.
bool expected(const Ray<double> &ray, const Box<float> &box) {
    return exact::answer(ray, box).may_hit() || holds(box, point_at(ray, ray.t_min));
}

void ask(Check &check, const Task &task, const Ray<double> &ray, const Box<float> &box) {
    check.given({{"ray", ray}, {"lo", box.lo}, {"hi", box.hi}});
    check.same("whether the ray meets the box", task.meets_box(ray, box), expected(ray, box));
}

// Only where a box a little larger and one a little smaller agree: elsewhere the last bits decide.
void ask_if_clear(Check &check, const Task &task, const Ray<double> &ray, const Box<float> &box) {
    if (expected(ray, grown(box, 0.01f)) == expected(ray, grown(box, -0.01f)))
        ask(check, task, ray, box);
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why, const char *heading) {
        return Question{name, why, "09_aabb", heading};
    };

    grading.check(question("a box ahead is met, one beside it is missed",
                           "A ray is between two parallel planes for one interval of t. It is in the box where it is "
                           "between all three pairs at once: from the latest entry to the earliest exit.",
                           "The slab test"),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 400; ++i) {
                          Random random(1, i);
                          const Box<float> box = any_box(random);
                          const Vec<double> lo(box.lo), origin = lo - abs(any_point(random, 2)) - 0.2;
                          const Vec<double> target = lo + 3. * abs(any_point(random, 1)) * Vec<double>(box.hi - box.lo);
                          ask_if_clear(check, task, {origin, target - origin}, box);
                      }
                  });

    grading.check(question("the ray may run backwards along an axis",
                           "Where a component of the direction is negative, the ray comes through hi first and leaves "
                           "through lo. Take the smaller of the two t for the entry and the larger for the exit.",
                           "The slab test"),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 400; ++i) {
                          Random random(2, i);
                          const Vec<double> origin = any_point(random, 4), direction = any_point(random, 1);
                          const Box<float> box = any_box(random);
                          if (!expected({origin, -direction}, box)) // what lies behind comes later
                              ask_if_clear(check, task, {origin, direction}, box);
                      }
                  });

    grading.check(question("from inside, the box is met",
                           "The entry lies behind the origin, at a negative t. What counts is that the exit does not.",
                           "The slab test"),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(3, i);
                          const Box<float> box = any_box(random);
                          ask(check, task, {Vec<double>(box.lo + 0.5f * (box.hi - box.lo)), any_point(random, 1)}, box);
                      }
                  });

    grading.check(question("a box behind the origin is not met",
                           "Both ends of the interval are negative there. The ray begins at t_min: the entry is never "
                           "earlier than that.",
                           "The slab test"),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(4, i);
                          const Box<float> box = any_box(random);
                          const Vec<double> origin = Vec<double>(box.hi) + abs(any_point(random, 2)) + 0.2;
                          ask(check, task, {origin, abs(any_point(random, 1)) + 0.1}, box);
                      }
                  });

    grading.check(question("a box beyond t_max is not met",
                           "A ray to a light ends at the light, and a search ends at the nearest hit so far: the exit "
                           "is never later than t_max.",
                           "The slab test"),
                  [&](Check &check) {
                      const Box<float> box{{-1, -1, -1}, {1, 1, 1}};
                      for (const double t_max : {0.5, 1.5, 2.5, 4.5, 9.}) // the faces are at t = 2 and 4
                          ask(check, task, {{0.2, 0.3, 3}, {0, 0, -1}, 0, t_max}, box);
                      for (const double t_min : {0.5, 2.5, 3.5, 4.5})
                          ask(check, task, {{0.2, 0.3, 3}, {0, 0, -1}, t_min, 9}, box);
                  });

    grading.check(question("a flat box is a box",
                           "The box of a triangle that lies flat has no thickness: entry and exit are the same t. With "
                           "enter < exit such a box, and every triangle in it, is lost.",
                           "The slab test"),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(6, i);
                          Box<float> box = any_box(random);
                          const int axis = static_cast<int>(random.bits() % 3);
                          box.lo[axis] = box.hi[axis] = std::round(box.hi[axis]);
                          Ray<double> ray{round(any_point(random, 4)), {0, 0, 0}};
                          ray.origin[axis] = double(box.lo[axis]) + (random.bits() % 2 ? 2 : -2);
                          ray.direction[axis] = ray.origin[axis] > double(box.lo[axis]) ? -1 : 1;
                          for (int k = 1; k < 3; ++k) { // through the middle of it
                              const int other = (axis + k) % 3;
                              ray.origin[other] = 0.5 * (double(box.lo[other]) + double(box.hi[other]));
                          }
                          ask(check, task, ray, box);
                      }
                  });

    grading.check(
        question("a ray along an axis is decided, also in the plane of a face",
                 "Where a component of the direction is 0, the two divisions give infinities; and 0 / 0, NaN, "
                 "where the origin lies in the plane as well. A ray parallel to two planes is between them "
                 "always or never: lo <= o <= hi decides.",
                 "The slab test"),
        [&](Check &check) {
            const Box<float> box{{-1, -1, -1}, {1, 1, 1}};
            for (const double zero : {0., -0.})
                for (const double x : {-2., -1., -0.5, 0., 1., 2.})
                    for (const double y : {-2., -1., 0.5, 1.}) {
                        ask(check, task, {{x, y, 3}, {zero, zero, -1}}, box);
                        ask(check, task, {{3, x, y}, {-1, zero, zero}}, box);
                        ask(check, task, {{y, -3, x}, {zero, 1, zero}}, box);
                    }
        });
}

} // namespace course
