// The octree's parts: cubes and their octants, nodes of eight bytes, the bound on entries, the order of the walk.
#include "chapters/09_aabb/counters.hpp"
#include "chapters/11_octree/octree.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace course;

namespace {

using Triangles = std::vector<Triangle<>>;

Triangles random_triangles(std::size_t count, double size, std::uint64_t seed) {
    Random random(seed);
    const auto point = [&](double reach) {
        return Vec<float>(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
    };
    Triangles list;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<float> a = point(1);
        list.push_back({a, a + point(size), a + point(size)});
    }
    return list;
}

TEST(Octree, EightOctantsFillTheirCube) {
    const Cube cube{{-1, 2, 3}, 4};
    double volume = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const Box<double> box = cube.octant(octant).box(0);
        const Vec<double> e = extent(box);
        volume += e.x * e.y * e.z;
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(box.lo[axis], cube.lo[axis] + (octant >> axis & 1 ? 2 : 0));
    }
    EXPECT_EQ(volume, 64);
}

TEST(Octree, TheCubeHoldsTheBoxAndFlatThingsLieAtItsBorder) {
    const Cube cube = cube_around({{-1, 5, -2}, {3, 5, 0}});
    EXPECT_NEAR(cube.edge, 4, 1e-9);
    EXPECT_LT(cube.lo.y, 5);
    EXPECT_NEAR(cube.lo.y, 5, 1e-9);
    EXPECT_GT(cube_around({{0, 0, 0}, {0, 0, 0}}).edge, 0);
}

TEST(Octree, AMissingChildTakesNoPlace) {
    const OctreeNode node = OctreeNode::inner(100, 0b10010100);
    EXPECT_FALSE(node.is_leaf());
    EXPECT_EQ(node.child(2), 100u);
    EXPECT_EQ(node.child(4), 101u);
    EXPECT_EQ(node.child(7), 102u);
    const OctreeNode leaf = OctreeNode::leaf(7, 0xffffff);
    EXPECT_TRUE(leaf.is_leaf());
    EXPECT_EQ(leaf.count(), 0xffffffu);
    EXPECT_THROW(OctreeNode::leaf(7, 0x1000000), std::length_error);
    EXPECT_THROW(OctreeNode::inner(std::size_t{1} << 32, 1), std::length_error);
}

TEST(Octree, SlotsAreNumberedByAppearance) {
    std::vector<Id> entries{5, 2, 5, 9, 2, 0};
    EXPECT_EQ(number_by_appearance(entries, 10), (std::vector<Id>{5, 2, 9, 0}));
    EXPECT_EQ(entries, (std::vector<Id>{0, 1, 0, 2, 1, 3}));
}

// A bundle of needles along the diagonal: every level divides each of them once more, and nothing is gained.
TEST(Octree, NoShapeCostsMoreEntriesThanTheRuleAllows) {
    Triangles bundle(200, Triangle<>{{0, 0, 0}, {1, 1, 1}, {1, 1, 0.9999f}});
    for (const double most : {1.0, 4.0, 16.0}) {
        const Octree<Triangle<>> tree(bundle, {.most_entries = most});
        EXPECT_LE(static_cast<double>(tree.octants.entries.size()), most * 200);
        EXPECT_GE(tree.octants.entries.size(), 200u);
    }
    const Octree<Triangle<>> soup(random_triangles(2000, 0.3, 1), {.node_cost = 0, .most_entries = 6});
    EXPECT_LE(soup.octants.entries.size(), 12000u);
    EXPECT_GT(soup.octants.entries.size(), 4000u);
}

TEST(Octree, DepthAndLeavesAreAsTheRuleSays) {
    const Triangles list = random_triangles(500, 0.01, 2);
    EXPECT_EQ(Octree<Triangle<>>(list, {.deepest = 0}).octants.nodes.size(), 1u);
    EXPECT_LE(Octree<Triangle<>>(list, {.deepest = 1}).octants.nodes.size(), 9u);
    EXPECT_EQ(Octree<Triangle<>>(list, {.small_leaf = 500}).octants.nodes.size(), 1u);
    // Nothing can divide what lies in one place: the cells end where the walk could not tell them apart.
    const Octree<Triangle<>> same(Triangles(50, list.front()));
    EXPECT_LE(same.octants.nodes.size(), 1000u);
}

// The boxes of slanted triangles reach into cells that the triangles themselves do not.
TEST(Octree, AskingTheShapeSavesEntries) {
    const Triangles list = random_triangles(3000, 0.1, 3);
    const auto entries = [&](bool exact) {
        return Octree<Triangle<>>(list, {.deepest = 5, .exact = exact}).octants.entries.size();
    };
    EXPECT_LT(entries(true), 0.8 * static_cast<double>(entries(false)));
}

// Hits in the order of the leaves: the nearest is among the first few offers, from whichever side the ray comes.
TEST(Octree, NearLeavesComeFirst) {
    Triangles row;
    for (int i = 0; i < 256; ++i) {
        const auto x = static_cast<float>(i);
        row.push_back({{x, -1, -1}, {x + 0.1f, 2, -1}, {x, -1, 2}});
    }
    const Octree<Triangle<>> tree(row);
    for (const double side : {-1.0, 1.0}) {
        Counts counts;
        const Ray<double> ray{{side < 0 ? -5.0 : 260.0, 0.01, 0.02}, {-side, 0.001, 0.002}};
        const auto hit = closest_hit(CountedRay<>{ray, &counts}, tree);
        EXPECT_EQ(hit.id, side < 0 ? 0u : 255u);
        EXPECT_LE(counts.tests, 8u);
        EXPECT_LE(counts.nodes, 40u);
    }
}

} // namespace
