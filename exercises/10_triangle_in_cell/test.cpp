// Grades exercise 10, the second: does a triangle reach into a cell?
#include "exercises/10_triangle_in_cell/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <vector>

namespace course {

namespace {

// Cuts the triangle off at each face of the box in turn: whatever is left lies in the box.
bool anything_left(const Triangle<float> &triangle, const Box<double> &box) {
    std::vector<Vec<double>> polygon{Vec<double>(triangle.a), Vec<double>(triangle.b), Vec<double>(triangle.c)};
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1., -1.}) {
            const double border = side > 0 ? box.hi[axis] : -box.lo[axis];
            std::vector<Vec<double>> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec<double> &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
                const double above_p = side * p[axis] - border, above_q = side * q[axis] - border;
                if (above_p <= 0)
                    kept.push_back(p);
                if ((above_p < 0 && above_q > 0) || (above_p > 0 && above_q < 0))
                    kept.push_back(p + above_p / (above_p - above_q) * (q - p));
            }
            polygon = kept;
        }
    return !polygon.empty();
}

Box<double> grown(const Box<double> &box, double by) { return {box.lo - by, box.hi + by}; }

// Asks only where a slightly larger and a slightly smaller box agree. Says how often the answer was yes.
void ask(Check &check, const Task &task, const Triangle<float> &triangle, const Box<double> &box) {
    const bool expected = anything_left(triangle, box);
    if (anything_left(triangle, grown(box, 1e-4)) != expected || anything_left(triangle, grown(box, -1e-4)) != expected)
        return;
    check.given({{"a", triangle.a}, {"b", triangle.b}, {"c", triangle.c}, {"lo", box.lo}, {"hi", box.hi}});
    check.same("whether the triangle reaches into the box", task.overlaps(triangle, box), expected);
}

Triangle<float> any_triangle(Random &random, double size) {
    return {Vec<float>(any_point(random, size)), Vec<float>(any_point(random, size)),
            Vec<float>(any_point(random, size))};
}

const Box<double> cell{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};

// Whether the triangle's own box and the cell are apart: the easy no.
bool boxes_apart(const Triangle<float> &t) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::min({t.a[axis], t.b[axis], t.c[axis]}) > 0.5f || std::max({t.a[axis], t.b[axis], t.c[axis]}) < -0.5f)
            return true;
    return false;
}

// Whether the whole cell lies on one side of the triangle's plane.
bool plane_apart(const Triangle<float> &t) {
    const Vec<double> n = cross(Vec<double>(t.b - t.a), Vec<double>(t.c - t.a));
    const double reach = 0.5 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    return std::abs(dot(n, Vec<double>(t.a))) > reach;
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "10_uniform_grid", "Which cells does a triangle reach into?"};
    };

    grading.check(question("a triangle with a corner in the cell reaches into it",
                           "If no line can be found on which the two shadows are apart, the bodies overlap."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(1, i);
                          Triangle<float> triangle = any_triangle(random, 3);
                          triangle.a = Vec<float>(any_point(random, 0.45));
                          ask(check, task, triangle, cell);
                      }
                  });

    grading.check(question("a triangle beside the cell does not",
                           "Look along the axes first: the triangle's own box and the cell are apart."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 2000; ++i) {
                          Random random(2, i);
                          if (const auto triangle = any_triangle(random, 3); boxes_apart(triangle))
                              ask(check, task, triangle, cell);
                      }
                  });

    grading.check(question("a triangle whose plane passes the cell by does not",
                           "The triangle's box may hold the cell although the triangle is far from it. Look along the "
                           "triangle's plane, that is, project both onto its normal."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 3000; ++i) {
                          Random random(3, i);
                          const auto triangle = any_triangle(random, 3);
                          if (!boxes_apart(triangle) && plane_apart(triangle))
                              ask(check, task, triangle, cell);
                      }
                  });

    grading.check(
        question("a triangle that reaches through the cell with its middle does",
                 "None of its corners is in the cell, and the cell has none of its corners in the triangle's "
                 "prism. A shadow is an interval: the cell's reaches as far to either side of its middle as the "
                 "sum of |component| times half an edge, each taken positive."),
        [&](Check &check) {
            for (unsigned i = 0; i < 3000; ++i) {
                Random random(4, i);
                const auto triangle = any_triangle(random, 3);
                if (anything_left(triangle, cell))
                    ask(check, task, triangle, cell);
            }
        });

    grading.check(
        question("a triangle that passes the cell's edge with its own does not",
                 "Neither the axes nor the normal tells these apart; the cross products of an edge of the one "
                 "with an edge of the other do. There are nine."),
        [&](Check &check) {
            for (unsigned i = 0; i < 20000; ++i) {
                Random random(5, i);
                const auto triangle = any_triangle(random, 2);
                if (!boxes_apart(triangle) && !plane_apart(triangle) && !anything_left(triangle, cell))
                    ask(check, task, triangle, cell);
            }
        });

    grading.check(question("the cell may lie anywhere and have any shape",
                           "Project the cell's middle, and half of each of its edges."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 4000; ++i) {
                          Random random(6, i);
                          const Vec<double> middle = any_point(random, 20), half = abs(any_point(random, 2)) + 0.1;
                          Triangle<float> triangle = any_triangle(random, 3);
                          for (Vec<float> *corner : {&triangle.a, &triangle.b, &triangle.c})
                              *corner += Vec<float>(middle);
                          ask(check, task, triangle, {middle - half, middle + half});
                      }
                  });
}

} // namespace course
