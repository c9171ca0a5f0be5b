// Grades exercise 08: a triangle that shares its edges fairly.
#include "exercises/08_watertight_edge/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <array>

namespace course {

namespace {

using Flat = std::array<Corner, 3>;

std::string words_of(const Flat &flat) {
    std::string words;
    for (const Corner &corner : flat)
        words += (words.empty() ? "(" : ", (") + in_words(corner.x) + ", " + in_words(corner.y) + ")";
    return words;
}

bool ask(const Task &task, const Flat &flat) { return task.holds_ray(flat[0], flat[1], flat[2]); }

// Of these triangles so many must hold the ray (or any even number).
void count(Check &check, const Task &task, const std::vector<Flat> &mesh, int expected, bool even = false) {
    int held = 0;
    std::vector<Fact> facts;
    for (const Flat &flat : mesh) {
        held += ask(task, flat);
        facts.push_back({"triangle", words_of(flat)});
    }
    check.given(facts);
    check.that(even ? held % 2 == 0 : held == expected,
               even ? "an even number of them holds (0, 0)" : std::to_string(expected) + " of them holds (0, 0)",
               std::to_string(held));
}

int whole(Random &random, int most) { return static_cast<int>(random.uniform(-most, most + 1)); }
Corner any_corner(Random &random, int most) { return {double(whole(random, most)), double(whole(random, most))}; }
double area(const Flat &f) { return (f[1].x - f[0].x) * (f[2].y - f[0].y) - (f[1].y - f[0].y) * (f[2].x - f[0].x); }

// with any of its corners first, as long as the winding stays.
Flat turned(Flat flat, Random &random) {
    std::ranges::rotate(flat, flat.begin() + random.bits() % 3);
    return flat;
}

// Two triangles on both sides of an edge through the origin, wound alike.
std::vector<Flat> neighbours(Random &random, const Corner &p, const Corner &q) {
    for (;;) {
        const Corner left = any_corner(random, 9), right = any_corner(random, 9);
        const Flat one{p, q, left}, other{q, p, right};
        if (area(one) > 0 && area(other) > 0)
            return {turned(one, random), turned(other, random)};
    }
}

// A ring of corners around the origin, as multiples of these directions, and the triangles from the origin to them.
std::vector<Flat> fan(Random &random) {
    const Corner around[] = {{1, 0}, {2, 1}, {1, 1}, {0, 1}, {-1, 2}, {-1, 0}, {-1, -1}, {0, -1}, {2, -1}};
    std::vector<Corner> ring;
    for (const Corner &direction : around)
        if (const double size = 1 + random.bits() % 5; random.bits() % 4 != 0 || direction.x * direction.y == 0)
            ring.push_back({size * direction.x, size * direction.y});
    std::vector<Flat> mesh;
    for (std::size_t i = 0; i < ring.size(); ++i)
        mesh.push_back(turned({Corner{0, 0}, ring[i], ring[(i + 1) % ring.size()]}, random));
    return mesh;
}

// An octahedron with corners on whole numbers, seen so that one corner, or the middle of one edge, is at the origin.
std::vector<Flat> octahedron(Random &random, bool at_corner) {
    std::array<Corner, 6> seen;
    for (Corner &corner : seen)
        corner = any_corner(random, 4);
    const Corner shift = at_corner ? seen[0] : Corner{(seen[0].x + seen[1].x) / 2, (seen[0].y + seen[1].y) / 2};
    for (Corner &corner : seen)
        corner = {corner.x - shift.x, corner.y - shift.y};
    // Corners 0 and 5 are opposite, so are 1 and 3, 2 and 4.
    std::vector<Flat> mesh;
    for (int side = 1; side <= 4; ++side) {
        const auto next = static_cast<std::size_t>(side % 4 + 1), here = static_cast<std::size_t>(side);
        mesh.push_back({seen[0], seen[here], seen[next]});
        mesh.push_back({seen[5], seen[next], seen[here]});
    }
    return mesh;
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("08_mesh");
    const char *const watertight = "The watertight test", *const leaks = "Why it leaks";

    grading.check(
        "a triangle around the ray holds it, another does not",
        "For each edge, q.x p.y - q.y p.x tells on which side of it (0, 0) lies. It is inside when all three agree.",
        watertight, [&](Check &check) {
            for (unsigned i = 0; i < 500; ++i) {
                Random random(1, i);
                const auto corner = [&] { return Corner{random.uniform(-1, 1), random.uniform(-1, 1)}; };
                const Corner a = corner(), b = corner(), c = corner();
                const Flat flat = area({a, b, c}) < 0 ? Flat{a, b, c} : Flat{a, c, b};
                const auto at = [](const Corner &p) { return Vec<double>(p.x, p.y, 1); };
                const auto truth = exact::triangle({{0, 0, 0}, {0, 0, 1}}, at(flat[0]), at(flat[1]), at(flat[2]));
                count(check, task, {flat}, truth.may_hit());
            }
        });

    grading.check(
        "both sides of a triangle count",
        "From behind, the corners run the other way round and all three signs are turned around. They still agree.",
        watertight, [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(2, i);
                const auto far = [&](double x, double y) {
                    return Corner{x + random.uniform(-0.3, 0.3), y + random.uniform(-0.3, 0.3)};
                };
                const Flat flat{far(1, -1), far(0, 1), far(-1, -1)};
                count(check, task, {turned(flat, random)}, 1);
                count(check, task, {turned({flat[1], flat[0], flat[2]}, random)}, 1);
            }
        });

    grading.check(
        "through an edge: one of the two neighbours",
        "The ray runs exactly through the edge, where its edge function is 0. With > 0 neither neighbour is hit, with "
        ">= 0 both. Neighbours have the edge in opposite directions: give 0 a sign that turns around with the edge, by "
        "pretending that the ray passes a hair beside.",
        watertight, [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(3, i);
                const Corner direction = any_corner(random, 4);
                if (direction.y == 0)
                    continue;
                const double p = 1 + random.bits() % 3, q = -1. - random.bits() % 3;
                count(check, task,
                      neighbours(random, {p * direction.x, p * direction.y}, {q * direction.x, q * direction.y}), 1);
            }
        });

    grading.check(
        "a level edge is no exception",
        "Which end is higher does not tell the two directions of a level edge apart. Then the other coordinate must: a "
        "hair to the right, and a hair of that hair above.",
        watertight, [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(4, i);
                const double p = 1 + random.bits() % 3, q = -1. - random.bits() % 3;
                count(check, task, neighbours(random, {p, 0}, {q, 0}), 1);
                count(check, task, neighbours(random, {q, 0}, {p, 0}), 1);
            }
        });

    grading.check(
        "through a corner: one of all around it",
        "At a corner two edge functions of each triangle are 0. If all of them pretend the same, that the ray passes a "
        "hair beside, exactly one triangle of the ring is hit.",
        watertight, [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(5, i);
                count(check, task, fan(random), 1);
            }
        });

    grading.check(
        "a closed surface is hit an even number of times",
        "A line that enters a closed surface leaves it again, also where it runs through an edge or a corner at the "
        "surface's outline: there it meets two triangles or none.",
        leaks, [&](Check &check) {
            for (unsigned i = 0; i < 500; ++i) {
                Random random(6, i);
                count(check, task, octahedron(random, i % 2 == 0), 0, true);
            }
        });

    grading.check("there is no tolerance in it",
                  "An epsilon calls 0 what is not, for small triangles always. A ray a hair beside the edge belongs to "
                  "one of the two, "
                  "and so does one in triangles a billionth in size. Only what is exactly 0 needs the rule.",
                  leaks, [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(7, i);
                          const Corner direction{1, random.uniform(-2, 2)};
                          const double hair = (i % 2 ? 1e-10 : -1e-12), size = i % 3 == 0 ? 1e-9 : 1;
                          auto mesh = neighbours(random, {4, 3}, {-4, -3});
                          for (Flat &flat : mesh)
                              for (Corner &corner : flat)
                                  corner = {size * (corner.x + hair), size * (corner.y + hair * direction.y)};
                          count(check, task, mesh, 1);
                          count(check, task, {{Corner{-3e-7, -2e-7}, {4e-7, -1e-7}, {0, 5e-7}}}, 1);
                          count(check, task, {{Corner{2e-7, 2e-7}, {7e-7, 1e-7}, {3e-7, 5e-7}}}, 0);
                      }
                  });
}

} // namespace course
