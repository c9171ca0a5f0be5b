// Grades exercise 11: which of an octree cell's eight children does a ray meet, and in what order?
#include "exercises/11_octree_children/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <string>

namespace course {

namespace {

struct Visit {
    double enter, exit;
    int child;
};

// What of the ray lies in one child, by cutting with its six planes.
Visit visit(const Ray<double> &ray, const Box<double> &cell, int child) {
    Visit in{ray.t_min, ray.t_max, child};
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = 0.5 * (cell.lo[axis] + cell.hi[axis]);
        const double lo = child >> axis & 1 ? middle : cell.lo[axis], hi = child >> axis & 1 ? cell.hi[axis] : middle;
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0) {
            if (o < lo || o > hi)
                in.exit = -1;
            continue;
        }
        in.enter = std::max(in.enter, ((d > 0 ? lo : hi) - o) / d);
        in.exit = std::min(in.exit, ((d > 0 ? hi : lo) - o) / d);
    }
    return in;
}

std::string text(const std::vector<int> &children) {
    std::string all = children.empty() ? "none" : "";
    for (const int child : children)
        all += (all.empty() ? "" : ", ") + std::to_string(child);
    return all;
}

// Asks all eight and sorts. Where the ray clips a corner by a hair, rounding decides; such rays are left out.
void ask(Check &check, const Task &task, const Ray<double> &ray, const Box<double> &cell) {
    std::vector<Visit> visits;
    for (int child = 0; child < 8; ++child) {
        const Visit in = visit(ray, cell, child);
        if (std::abs(in.exit - in.enter) * length(ray.direction) < 1e-6)
            return;
        if (in.enter < in.exit)
            visits.push_back(in);
    }
    std::ranges::sort(visits, {}, &Visit::enter);
    std::vector<int> expected;
    for (const Visit &in : visits)
        expected.push_back(in.child);
    check.given({{"ray", ray}, {"lo", cell.lo}, {"hi", cell.hi}});
    const auto yours = task.children_met(ray, cell);
    check.that(yours == expected, "children " + text(expected) + ", in this order", text(yours));
}

Box<double> any_cell(Random &random) {
    const Vec<double> middle = any_point(random, 2), half = abs(any_point(random, 1)) + 0.3;
    return {middle - half, middle + half};
}

// A point in the cell.
Vec<double> inside(const Box<double> &cell, Random &random) {
    return cell.lo + (cell.hi - cell.lo) * abs(any_point(random, 1));
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "11_octree", "The walk: from near to far, without a division"};
    };

    grading.check(question("a ray that runs upwards meets its children in order",
                           "It begins in one child and changes to another where it crosses a middle plane: x, y or z, "
                           "whichever comes first. So at most four children are met, and each differs from the one "
                           "before in one bit."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 400; ++i) {
                          Random random(1, i);
                          const Box<double> cell = any_cell(random);
                          const Vec<double> origin = cell.lo - abs(any_point(random, 1)) - 0.1;
                          ask(check, task, {origin, inside(cell, random) - origin}, cell);
                      }
                  });

    grading.check(question("the ray may run backwards along an axis",
                           "Then it begins in the upper half of that axis, with the bit set, and loses the bit at the "
                           "middle plane."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 600; ++i) {
                          Random random(2, i);
                          const Box<double> cell = any_cell(random);
                          const Vec<double> sign{i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.};
                          const Vec<double> origin =
                              0.5 * (cell.lo + cell.hi) +
                              sign * (0.5 * (cell.hi - cell.lo) + abs(any_point(random, 1)) + 0.1);
                          ask(check, task, {origin, inside(cell, random) - origin}, cell);
                      }
                  });

    grading.check(question("a ray that begins in the cell meets nothing behind it",
                           "The first child is the one that holds the point where the ray enters the cell, or, from "
                           "inside, its origin. A middle plane that was crossed before that does not count."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 600; ++i) {
                          Random random(3, i);
                          const Box<double> cell = any_cell(random);
                          ask(check, task, {inside(cell, random), any_point(random, 1)}, cell);
                      }
                  });

    grading.check(question("a cell that the ray does not meet has no children to visit",
                           "Where the interval in the cell is empty, so is the list."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(4, i);
                          ask(check, task, {any_point(random, 5), any_point(random, 1)}, any_cell(random));
                      }
                  });

    grading.check(
        question("nothing beyond t_max is visited",
                 "A middle plane that is crossed beyond t_max, or where the cell has been left, does not count."),
        [&](Check &check) {
            for (unsigned i = 0; i < 400; ++i) {
                Random random(5, i);
                const Box<double> cell = any_cell(random);
                ask(check, task, {inside(cell, random), any_point(random, 1), 0, random.uniform(0.1, 2)}, cell);
            }
        });

    grading.check(question("a component of 0 crosses no middle plane",
                           "The side is then that of the origin, for the whole of the ray."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 400; ++i) {
                          Random random(6, i);
                          const Box<double> cell = any_cell(random);
                          Vec<double> direction = any_point(random, 1);
                          direction[static_cast<int>(i % 3)] = i % 2 ? 0. : -0.;
                          ask(check, task, {inside(cell, random) - 3. * direction, direction}, cell);
                      }
                  });
}

} // namespace course
