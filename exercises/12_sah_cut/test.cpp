// Grades exercise 12: where does a kd-tree cut a cell?
#include "exercises/12_sah_cut/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>

namespace course {

namespace {

constexpr double node_cost = 1; // as the task says, in units of one test

// What a cut costs, from what the words mean: every box is asked on which side it has something.
double cost_of(std::span<const Box<float>> boxes, const Box<float> &cell, int axis, float at) {
    Box<float> below = cell, above = cell;
    below.hi[axis] = above.lo[axis] = at;
    std::size_t in_below = 0, in_above = 0;
    for (const Box<float> &box : boxes) {
        in_above += box.hi[axis] > at;
        in_below += box.lo[axis] < at || box.hi[axis] <= at;
    }
    return node_cost +
           (area_of(below) * static_cast<double>(in_below) + area_of(above) * static_cast<double>(in_above)) /
               area_of(cell);
}

// The least that any cut costs: tried at every border of every box, and between. No cut can be better elsewhere, since
// between two borders the cost is a straight line.
double least_cost(std::span<const Box<float>> boxes, const Box<float> &cell) {
    double least = infinity<double>;
    for (int axis = 0; axis < 3; ++axis)
        for (const Box<float> &box : boxes)
            for (const float at : {box.lo[axis], box.hi[axis]})
                if (at > cell.lo[axis] && at < cell.hi[axis])
                    least = std::min(least, cost_of(boxes, cell, axis, at));
    return least;
}

void ask(Check &check, const Task &task, const std::vector<Box<float>> &boxes, const Box<float> &cell) {
    check.given({{"boxes", boxes.size()},
                 {"cell from", cell.lo},
                 {"to", cell.hi},
                 {"first box from", boxes[0].lo},
                 {"first box to", boxes[0].hi}});
    const auto yours = task.best_cut(boxes, cell);
    const double least = least_cost(boxes, cell), leaf = static_cast<double>(boxes.size());
    if (!yours) {
        check.that(least > leaf * (1 - 1e-9), "a cut, which costs " + std::to_string(least), "none");
        return;
    }
    check.that(least < leaf * (1 + 1e-9), "no cut: a leaf costs " + std::to_string(leaf),
               "one that costs " + std::to_string(cost_of(boxes, cell, yours->axis, yours->at)));
    check.that(yours->axis >= 0 && yours->axis < 3 && yours->at > cell.lo[yours->axis] &&
                   yours->at < cell.hi[yours->axis],
               "a plane within the cell", "axis " + std::to_string(yours->axis) + " at " + std::to_string(yours->at));
    const double cost = cost_of(boxes, cell, yours->axis, yours->at);
    check.that(cost <= least * (1 + 1e-9), "a cut that costs " + std::to_string(least),
               "axis " + std::to_string(yours->axis) + " at " + std::to_string(yours->at) + ", which costs " +
                   std::to_string(cost));
    check.number("the cost that you give", yours->cost, cost, 1e6);
}

Vec<double> unit_point(Random &random) { return {random.uniform(), random.uniform(), random.uniform()}; }

// Boxes of about that size, in a cell of edge 8.
std::vector<Box<float>> some_boxes(Random &random, std::size_t count, double size) {
    std::vector<Box<float>> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<double> lo = (8 - size) * unit_point(random), edges = size * unit_point(random);
        boxes.push_back({Vec<float>(lo), Vec<float>(lo + edges)});
    }
    return boxes;
}

const Box<float> whole{{0, 0, 0}, {8, 8, 8}};

// Boxes that no plane across an axis finds side by side: each has its own part of every axis. `count` is a prime, so
// the multiples of any number come to every part once.
std::vector<Box<float>> boxes_apart(Random &random, unsigned count) {
    std::vector<Box<float>> boxes(count);
    for (int axis = 0; axis < 3; ++axis) {
        const unsigned factor = 1 + random.bits() % (count - 1);
        for (unsigned i = 0; i < count; ++i) {
            const double width = 8. / count, lo = width * (i * factor % count + random.uniform(0.1, 0.5));
            boxes[i].lo[axis] = static_cast<float>(lo);
            boxes[i].hi[axis] = static_cast<float>(lo + width * random.uniform(0.1, 0.4));
        }
    }
    return boxes;
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "12_kd_tree", "Where to cut: the least cost"};
    };

    grading.check(
        question(
            "two groups are cut apart, where the empty space begins",
            "A ray that passes the cell meets a part of it as often as the part's surface (not its volume) is large. "
            "So the "
            "best plane lies close to the group with more boxes, not in the middle between the two: the large part "
            "then costs little."),
        [&](Check &check) {
            const Box<float> flat{{0, 0, 0}, {8, 2, 2}};
            const std::vector<Box<float>> boxes{{{0, 0, 0}, {1.5, 2, 2}},
                                                {{0.25, 0, 0}, {1.5, 2, 2}},
                                                {{0.5, 0, 0}, {1.5, 2, 2}},
                                                {{0, 0, 0}, {1.5, 2, 2}},
                                                {{4.5, 0, 0}, {6.5, 2, 2}}};
            ask(check, task, boxes, flat);
        });

    grading.check(
        question("the cheapest of all cuts is found, on every axis",
                 "The cost is node + (A_below n_below + A_above n_above) / A_cell, with the surfaces of the two "
                 "parts. It jumps only where a box begins or ends, so only these planes can be best; on three "
                 "axes."),
        [&](Check &check) {
            for (unsigned i = 0; i < 60; ++i) {
                Random random(2, i);
                static constexpr unsigned primes[]{5, 7, 11, 13, 17, 23};
                ask(check, task, boxes_apart(random, primes[i % 6]), whole);
            }
        });

    grading.check(question("a box that the plane cuts is in both parts",
                           "It will be tested in both, so it counts in both. Counted by its middle alone, cuts through "
                           "many boxes look cheaper than they are."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 60; ++i) {
                          Random random(3, i);
                          ask(check, task, some_boxes(random, 12 + random.bits() % 30, 4), whole);
                      }
                  });

    grading.check(
        question("where no cut is worth its node, a leaf is made",
                 "A leaf costs one test for each box. Boxes that all overlap cannot be parted: a cut costs a node "
                 "more and saves nothing."),
        [&](Check &check) {
            ask(check, task, {{{1, 1, 1}, {7, 7, 7}}, {{0.5, 1, 1}, {7, 7.5, 7}}, {{1, 1, 2}, {7, 7, 7.5}}}, whole);
            ask(check, task, {{{0, 0, 0}, {8, 8, 8}}}, whole);
            ask(check, task, {{{0, 0, 0}, {1, 1, 1}}}, {{0, 0, 0}, {1.0625, 1, 1}});
            for (unsigned i = 0; i < 60; ++i) {
                Random random(4, i);
                ask(check, task, some_boxes(random, 2 + random.bits() % 3, 7), whole);
            }
        });

    grading.check(
        question("boxes without thickness are not lost, nor counted twice",
                 "A flat box that lies in the plane belongs to one part: here, to the lower one. One that only "
                 "touches the plane belongs to its own side."),
        [&](Check &check) {
            for (unsigned i = 0; i < 60; ++i) {
                Random random(5, i);
                auto boxes = some_boxes(random, 24, 2);
                for (Box<float> &box : boxes) {
                    box = {round(box.lo), round(box.hi)};
                    const int axis = static_cast<int>(random.bits() % 3);
                    box.lo[axis] = box.hi[axis];
                }
                ask(check, task, boxes, whole);
            }
        });
}

} // namespace course
