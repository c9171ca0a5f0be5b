// The parts of the uniform grid: overlap, lattice, lists, walk.
#include "chapters/09_aabb/slab.hpp"
#include "chapters/10_uniform_grid/grid.hpp"
#include "chapters/10_uniform_grid/scenes.hpp"

#include <gtest/gtest.h>
#include <map>

namespace {

using namespace course;

Vec<double> random_vector(Random &random, double size = 1) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Box<double> grown(const Box<double> &box, double by) { return {box.lo - by, box.hi + by}; }

// What is left of the triangle when the outside of each of the box's six planes is cut off (Sutherland and Hodgman):
// nothing, if they do not overlap. Has nothing in common with separating lines.
bool clipped_away(const Triangle<> &triangle, const Box<double> &box) {
    std::vector<Vec<double>> polygon{Vec<double>(triangle.a), Vec<double>(triangle.b), Vec<double>(triangle.c)};
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            const auto inside = [&](const Vec<double> &p) {
                return side < 0 ? p[axis] - box.lo[axis] : box.hi[axis] - p[axis];
            };
            std::vector<Vec<double>> rest;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec<double> p = polygon[i], q = polygon[(i + 1) % polygon.size()];
                const double at_p = inside(p), at_q = inside(q);
                if (at_p >= 0)
                    rest.push_back(p);
                if ((at_p >= 0) != (at_q >= 0))
                    rest.push_back(p + at_p / (at_p - at_q) * (q - p));
            }
            polygon = rest;
        }
    return polygon.empty();
}

TEST(Overlap, TriangleAndBoxAsByClipping) {
    Random random(1);
    int overlapping = 0, false_no = 0, false_yes = 0, box_says_yes = 0;
    for (int i = 0; i < 200000; ++i) {
        Triangle<> triangle{Vec<float>(random_vector(random)), Vec<float>(random_vector(random)),
                            Vec<float>(random_vector(random))};
        if (i % 4 == 1)
            triangle.c = triangle.b + 1e-3f * (triangle.c - triangle.b); // a needle
        if (i % 4 == 2)
            triangle.a.y = triangle.b.y = triangle.c.y; // in a plane across an axis
        const Vec<double> corner = random_vector(random);
        const Box<double> box{corner, corner + random.uniform(0.05, 1) * abs(random_vector(random))};
        const Overlap overlap(triangle);
        overlapping += overlap(box);
        false_no += !clipped_away(triangle, box) && !overlap(grown(box, 1e-12));
        false_yes += clipped_away(triangle, grown(box, 1e-6)) && overlap(box);
        box_says_yes += overlap(box) != Overlap<Box<>>(bounds(triangle))(box);
    }
    EXPECT_GT(overlapping, 5000);
    EXPECT_EQ(false_no, 0);
    EXPECT_EQ(false_yes, 0);
    EXPECT_GT(box_says_yes, 5000) << "a test by the triangle's box alone would have passed";
}

TEST(Overlap, TouchingIsOverlapping) {
    const Overlap overlap(Triangle<>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    EXPECT_TRUE(overlap({{0.25, 0.25, 0}, {0.3, 0.3, 1}}));   // a face in the plane
    EXPECT_TRUE(overlap({{0.5, 0.5, -1}, {1, 1, 1}}));        // an edge
    EXPECT_TRUE(overlap({{-1, -1, -1}, {0, 0, 0}}));          // a corner
    EXPECT_TRUE(overlap({{0.2, 0.2, 0}, {0.2, 0.2, 0}}));     // a box that is a point
    EXPECT_FALSE(overlap({{0.6, 0.6, -1}, {1, 1, 1}}));       // beside the long edge, within the triangle's box
    EXPECT_FALSE(overlap({{0.2, 0.2, 1e-9}, {0.4, 0.4, 1}})); // above
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(Overlap(Triangle<>{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}})({{0, 0, 0}, {1, 1, 1}})); // who knows
}

TEST(Overlap, SphereIsItsSurface) {
    const Overlap overlap(Sphere<>{{0, 0, 0}, 1});
    EXPECT_TRUE(overlap({{0.9, -0.1, -0.1}, {1.1, 0.1, 0.1}}));
    EXPECT_TRUE(overlap({{-2, -2, -2}, {2, 2, 2}}));
    EXPECT_TRUE(overlap({{1, -0.1, -0.1}, {1.1, 0.1, 0.1}})); // touches
    EXPECT_FALSE(overlap({{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}}));
    EXPECT_FALSE(overlap({{0.8, 0.8, 0.8}, {1, 1, 1}}));
}

TEST(Lattice, HasAboutAsManyCellsAsAskedForHoweverFlat) {
    for (const Vec<float> size : {Vec<float>(1, 1, 1), {10, 1, 0.5}, {1, 1, 0}, {5, 0, 2}, {0, 3, 0}, {100, 1, 1e-5}}) {
        const Lattice lattice({{-1, 2, 3}, Vec<float>(-1, 2, 3) + size}, 30000);
        EXPECT_NEAR(lattice.cells(), 30000, 9000) << size.x << ' ' << size.y << ' ' << size.z;
        const Vec<double> e = extent(lattice.box());
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(lattice.count[axis] == 1 || e[axis] / lattice.count[axis] < 1.8 * e.x / lattice.count.x ||
                        lattice.count.x == 1);
    }
    EXPECT_EQ(Lattice({{1, 2, 3}, {1, 2, 3}}, 1000).count, glm::ivec3(1)) << "a point: cells are wider than the margin";
    EXPECT_EQ(Lattice(empty_box(), 1000).count, glm::ivec3(1));
}

TEST(Lattice, ExpectedEntriesAreTheAverageOverPlaces) {
    Random random(2);
    Lattice lattice({{-3, -3, -3}, {3, 3, 3}}, 1);
    lattice.count = {30, 20, 10};
    lattice.cell = {0.2, 0.3, 0.6};
    lattice.margin = 0;
    for (int i = 0; i < 4; ++i) {
        const Triangle<> triangle{Vec<float>(random_vector(random)), Vec<float>(random_vector(random)),
                                  Vec<float>(random_vector(random))};
        const Overlap overlap(triangle);
        const Box<float> box = bounds(triangle);
        constexpr int places = 4000;
        double entries = 0;
        for (int j = 0; j < places; ++j) {
            lattice.lo = Vec<double>(-3) + Vec<double>(random.uniform(), random.uniform(), random.uniform());
            each_cell_of(overlap, lattice, lattice.cell_at(Vec<double>(box.lo)), lattice.cell_at(Vec<double>(box.hi)),
                         [&](const glm::ivec3 &) { ++entries; });
        }
        const double expected = lattice.expected_entries(1, overlap.footprint());
        EXPECT_NEAR(entries / places, expected, 0.02 * expected);
    }
}

TEST(CellLists, GiveBackWhatWasPutIn) {
    Random random(3);
    const glm::ivec3 count(9, 6, 13);
    CellLists lists(count);
    std::map<std::uint32_t, std::vector<Id>> expected;
    std::vector<Entry> entries;
    for (Id slot = 0; slot < 300; ++slot) {
        const glm::ivec3 cell(random.bits() % 9, random.bits() % 6, random.bits() % 13);
        entries.push_back({lists.number(cell), slot});
        expected[lists.number(cell)].push_back(slot);
    }
    lists.fill(entries);
    std::map<std::uint32_t, int> numbers;
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) {
                const auto found = lists.in({x, y, z});
                EXPECT_EQ(std::vector<Id>(found.begin(), found.end()), expected[lists.number({x, y, z})]);
                ++numbers[lists.number({x, y, z})];
            }
    EXPECT_EQ(numbers.size(), 9u * 6u * 13u) << "two cells have the same number";
    EXPECT_EQ(lists.entries(), 300u);

    CellLists empty(count);
    empty.fill({});
    EXPECT_TRUE(empty.in({8, 5, 12}).empty());
}

// The walk against a loop over all cells: none is passed over through whose inside the ray passes, none is visited that
// it does not even touch, and they come in the order of the ray.
TEST(CellWalk, VisitsWhatALoopOverAllCellsFinds) {
    Random random(4);
    const Lattice lattice({{-1, -1, -1}, {1, 1.5, 2}}, 500);
    const glm::ivec3 n = lattice.count;
    const auto vertex = [&] {
        const glm::ivec3 i(random.bits() % (n.x + 1), random.bits() % (n.y + 1), random.bits() % (n.z + 1));
        return lattice.lo + Vec<double>(i) * lattice.cell;
    };
    int visited = 0, missed = 0, strayed = 0, out_of_order = 0;
    for (int i = 0; i < 6000; ++i) {
        Ray<double> ray{random_vector(random, 3), random_vector(random)};
        if (i % 6 == 1)
            ray.direction[i / 6 % 3] = 0;
        if (i % 6 == 2)
            ray.direction = {0, i % 4 ? 1 : -1, 0};
        if (i % 6 == 3)
            ray.origin = vertex(), ray.direction = vertex() - ray.origin; // along planes and through vertices
        if (i % 6 == 4)
            ray.origin = random_vector(random, 1000), ray.direction = vertex() - ray.origin;
        if (i % 6 == 5)
            ray.origin = vertex(), ray.direction = {0, 0, i % 4 ? 1 : -1}; // along an edge
        if (ray.direction == Vec<double>(0))
            continue;
        const Span whole = span_within(ray, lattice.box());
        if (!(whole.enter < whole.exit) || whole.exit <= 0)
            continue;
        std::map<std::uint32_t, int> seen;
        const CellLists lists(n);
        CellWalk walk(ray, lattice, std::max(whole.enter, 0.0));
        double before = -infinity<double>;
        do {
            ++visited;
            ++seen[lists.number(walk.cell())];
            const Span here = span_within(ray, grown(lattice.box_of(walk.cell(), walk.cell()), 1e-9));
            strayed += !(here.enter <= here.exit);
            out_of_order += !(walk.leaves() >= before);
            before = walk.leaves();
        } while (walk.step());
        for (int z = 0; z < n.z; ++z)
            for (int y = 0; y < n.y; ++y)
                for (int x = 0; x < n.x; ++x) {
                    const Span inner = span_within(ray, grown(lattice.box_of({x, y, z}, {x, y, z}), -1e-9));
                    missed += inner.enter < inner.exit && inner.exit > 0 && !seen.contains(lists.number({x, y, z}));
                }
    }
    EXPECT_GT(visited, 20000);
    EXPECT_EQ(missed, 0);
    EXPECT_EQ(strayed, 0);
    EXPECT_EQ(out_of_order, 0);
}

TEST(CellWalk, EndsWhateverTheRay) {
    const Lattice lattice({{0, 0, 0}, {1, 1, 1}}, 1000);
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = infinity<double>;
    for (const double a : {0.0, -0.0, 1.0, 1e-320, -1e-320, 1e308, inf, nan})
        for (const double b : {0.0, -1.0, 1e-320, 1e308, -inf, nan})
            for (const double o : {0.5, 1e-320, -1e308, inf, nan})
                for (const double t : {0.0, inf, nan}) {
                    CellWalk walk(Ray<double>{{o, 0.5, 0.5}, {a, b, 0}}, lattice, t);
                    int steps = 0;
                    while (walk.leaves() <= infinity<double> && walk.step())
                        ASSERT_LT(++steps, 100) << a << ' ' << b << ' ' << o << ' ' << t;
                }
}

// Every point of a triangle is in a cell that lists it.
TEST(Grid, ListsATriangleWhereverItIs) {
    Random random(5);
    auto list = soup(300, 6);
    list.push_back({{-1, -1, -1}, {1, 1, 1}, {1, 1, 0.999f}});
    const Grid<Triangle<>> grid{std::span<const Triangle<>>(list)};
    int missing = 0;
    for (Id slot = 0; slot < grid.shapes.slots(); ++slot)
        for (int i = 0; i < 200; ++i) {
            const auto &[a, b, c] = grid.shapes[slot];
            const double u = random.uniform(), v = random.uniform(0, 1 - u);
            const auto here =
                grid.cells.in(grid.lattice.cell_at(Vec<double>(a) + u * Vec<double>(b - a) + v * Vec<double>(c - a)));
            missing += std::ranges::find(here, slot) == here.end();
        }
    EXPECT_EQ(missing, 0);
}

TEST(Grid, KeepsItsListsWithinMeasure) {
    std::vector<Triangle<>> large(3000);
    Random random(7);
    for (auto &[a, b, c] : large)
        a = Vec<float>(random_vector(random)), b = Vec<float>(random_vector(random)),
        c = Vec<float>(random_vector(random));
    const std::span<const Triangle<>> span(large);
    const CellsPerShape rule{.cells = 1000, .most_entries_per_shape = 20, .most_entries = 0};
    EXPECT_LE(static_cast<double>(Grid<Triangle<>>(span, rule).cells.entries()), 1.1 * 20 * 3000);
}

template <class T> int disagreements(const std::vector<Triangle<>> &list, double distance) {
    const Grid<Triangle<>> grid{std::span<const Triangle<>>(list)};
    const Scene brute(list);
    Random random(8);
    int wrong = 0, hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec<T> from(random_vector(random, distance)), to(list[random.bits() % list.size()].a);
        const Ray<T> ray{from, to - from};
        const auto expected = closest_hit(ray, brute), found = closest_hit(ray, grid);
        wrong += expected.id != found.id || expected.t != found.t;
        hits += bool(expected);
    }
    EXPECT_GT(hits, 500);
    return wrong;
}

TEST(Grid, AnswersRaysOfFloatsAndFromFarAway) {
    const auto list = soup(500, 9);
    for (const double distance : {0.5, 5.0, 500.0, 5e4}) {
        EXPECT_EQ(disagreements<double>(list, distance), 0) << distance;
        EXPECT_EQ(disagreements<float>(list, distance), 0) << distance;
    }
}

} // namespace
