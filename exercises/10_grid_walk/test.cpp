// Grades exercise 10: which cells does a ray pass, one after the other?
#include "exercises/10_grid_walk/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <cmath>

namespace course {

namespace {

struct Visit {
    double enter, exit;
    glm::ivec3 cell;
};

// The part of the ray in one cell, by cutting the ray with the cell's six planes.
Visit visit(const Ray<double> &ray, const SmallGrid &grid, const glm::ivec3 &cell) {
    Visit in{ray.t_min, ray.t_max, cell};
    for (int axis = 0; axis < 3; ++axis) {
        const double lo = grid.lo[axis] + grid.size * cell[axis], hi = lo + grid.size;
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0) {
            if (o < lo || o >= hi)
                in.exit = -1;
            continue;
        }
        in.enter = std::max(in.enter, ((d > 0 ? lo : hi) - o) / d);
        in.exit = std::min(in.exit, ((d > 0 ? hi : lo) - o) / d);
    }
    return in;
}

// Every cell that the ray is in for longer than a moment, in the order of the visits: found by asking all of them.
std::vector<Visit> all_visits(const Ray<double> &ray, const SmallGrid &grid) {
    std::vector<Visit> visits;
    for (int z = 0; z < grid.count.z; ++z)
        for (int y = 0; y < grid.count.y; ++y)
            for (int x = 0; x < grid.count.x; ++x)
                if (const Visit in = visit(ray, grid, {x, y, z}); in.enter < in.exit)
                    visits.push_back(in);
    std::ranges::sort(visits, {}, &Visit::enter);
    return visits;
}

// Whether a cell is only clipped at a corner, so that rounding may decide whether the ray is in it.
bool is_clear(const std::vector<Visit> &visits, const Ray<double> &ray) {
    return std::ranges::all_of(visits,
                               [&](const Visit &in) { return (in.exit - in.enter) * length(ray.direction) > 1e-6; });
}

std::string text(const glm::ivec3 &cell) {
    return "(" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ", " + std::to_string(cell.z) + ")";
}

// The same cells in the same order.
void ask(Check &check, const Task &task, const Ray<double> &ray, const SmallGrid &grid) {
    const auto expected = all_visits(ray, grid);
    if (!is_clear(expected, ray))
        return;
    check.given({{"ray", ray}, {"grid from", grid.lo}, {"cell size", grid.size}, {"cells", Vec<double>(grid.count)}});
    const auto yours = task.cells_along(ray, grid);
    for (std::size_t i = 0; i < std::min(yours.size(), expected.size()); ++i)
        check.that(yours[i] == expected[i].cell,
                   "cell number " + std::to_string(i + 1) + " is " + text(expected[i].cell), text(yours[i]));
    check.same("how many cells the ray passes", yours.size(), expected.size());
}

SmallGrid any_grid(Random &random) {
    const auto count = [&] { return 1 + static_cast<int>(random.bits() % 7); };
    const Vec<double> lo{random.uniform(-3, 0), random.uniform(-3, 0), random.uniform(-3, 0)};
    return {lo, random.uniform(0.3, 1.5), {count(), count(), count()}};
}

Vec<double> inside(const SmallGrid &grid, Random &random) {
    return grid.lo +
           grid.size * Vec<double>(grid.count) *
               Vec<double>(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99), random.uniform(0.01, 0.99));
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "10_uniform_grid", "The walk"};
    };

    grading.check(question("from cell to cell, the ray crosses the nearest border",
                           "For each axis keep the t at which the ray crosses its next border there. The smallest of "
                           "the three says through which side the ray leaves its cell; step there, and add the t from "
                           "one border to the next to that axis alone."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(1, i);
                          const SmallGrid grid = any_grid(random);
                          ask(check, task, {inside(grid, random), abs(any_direction(random)) + 0.01}, grid);
                      }
                  });

    grading.check(question("the ray may run backwards along an axis",
                           "Then the index goes down, the next border is the lower side of the cell, and the t between "
                           "two borders is still positive: size / |d|."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 400; ++i) {
                          Random random(2, i);
                          const SmallGrid grid = any_grid(random);
                          ask(check, task, {inside(grid, random), any_direction(random)}, grid);
                      }
                  });

    grading.check(question("a component of 0 never leads to a step",
                           "That axis has no next border: its t is infinity. 0 / 0 must not arise, and NaN must not "
                           "win a comparison."),
                  [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(3, i);
                          const SmallGrid grid = any_grid(random);
                          Vec<double> direction = any_direction(random);
                          direction[static_cast<int>(i % 3)] = i % 2 ? 0. : -0.;
                          if (i % 5 == 0)
                              direction[static_cast<int>((i + 1) % 3)] = 0;
                          ask(check, task, {inside(grid, random), direction}, grid);
                          const SmallGrid whole{{0, 0, 0}, 1, {4, 4, 4}}; // on a border, and along it
                          ask(check, task, {{2, 0.5, 0.5}, {0, 1, 0}}, whole);
                      }
                  });

    grading.check(
        question("the ray's interval ends the walk",
                 "A cell that is entered beyond t_max is not passed: the nearest hit so far lies before it."),
        [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(4, i);
                const SmallGrid grid = any_grid(random);
                ask(check, task, {inside(grid, random), any_direction(random), 0, random.uniform(0.1, 3)}, grid);
            }
        });

    grading.check(
        question("a step costs the same in a large grid as in a small one",
                 "A walk of n steps looks at n cells. It must not ask every cell, nor run along the ray in "
                 "small portions: those either skip a corner or come to the same cell again and again."),
        [&](Check &check) {
            for (const int n : {100, 1000, 100000}) {
                const SmallGrid grid{{0, 0, 0}, 1, {n, n, n}};
                const Ray<double> ray{{0.5, 0.25, 0.125}, {1, 1, 1}};
                check.given({{"ray", ray}, {"cells along each axis", n}});
                const auto yours = task.cells_along(ray, grid);
                check.same("how many cells the ray passes", yours.size(), static_cast<std::size_t>(3 * n - 2));
                check.that(yours.back() == glm::ivec3(n - 1), "the last is the far corner", text(yours.back()));
            }
        });
}

} // namespace course
