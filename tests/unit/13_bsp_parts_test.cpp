// The BSP-tree's parts: planes, polygons and cells that they cut, who goes to which side, and how trees degenerate.
#include "chapters/08_mesh/ball.hpp"
#include "chapters/13_bsp_tree/bsp.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

const Box<double> two_cube{{-1, -1, -1}, {1, 1, 1}};

Vec<double> random_vector(Random &random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(Bsp, APlanePassesThroughItsPoint) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec<double> far(1e4, -2e4, 3e4), point = far + random_vector(random);
        const SplitPlane plane = plane_across(random_vector(random), point);
        EXPECT_NEAR(plane.height(point), 0, 1e-11);
        EXPECT_NEAR(length(Vec<double>(plane.normal)), 1, 1e-6);
        EXPECT_GT(plane.height(point + Vec<double>(plane.normal)), 0.99);
    }
    EXPECT_EQ(plane_across({0, 0, 0}, {1, 2, 3}).normal, Vec<float>(0));
}

TEST(Bsp, APolygonIsCutInTwoThatFillIt) {
    const Polygon square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const SplitPlane diagonal = plane_across({1, 1, 0}, {0.5, 0.5, 0});
    const Polygon front = part_of(square, diagonal, 1), back = part_of(square, diagonal, -1);
    EXPECT_EQ(back.size(), 3u);
    EXPECT_EQ(front.size(), 5u);
    EXPECT_NEAR(vector_area(back).z, 0.5, 1e-6);
    EXPECT_NEAR(vector_area(front).z, 3.5, 1e-6);
    EXPECT_NEAR(vector_area_in_front(square, diagonal).z, 3.5, 1e-6);
    const SplitPlane outside = plane_across({1, 0, 0}, {5, 0, 0});
    EXPECT_TRUE(part_of(square, outside, 1).empty());
    EXPECT_EQ(part_of(square, outside, -1), square);
    EXPECT_EQ(vector_area_in_front(square, outside), Vec<double>(0));
}

// Cuts at random, one after the other: the scored surface is that of the part that is built, and parts stay closed.
TEST(Bsp, CellsStayClosedAndTheirSurfacesAreAsScored) {
    Random random(2);
    EXPECT_EQ(polytope_of(two_cube).surface(), 24);
    int slanted = 0;
    for (int round = 0; round < 200; ++round) {
        Polytope cell = polytope_of(two_cube);
        for (int cut = 0; cut < 8; ++cut) {
            Vec<double> middle(0);
            for (const Polygon &face : cell.faces)
                middle += face[0] / static_cast<double>(cell.faces.size());
            Vec<double> normal(0);
            if (cut % 3 == 0)
                normal[cut % 2] = 1;
            else
                normal = random_vector(random);
            const SplitPlane plane = plane_across(normal, middle);
            const auto surfaces = surfaces_of_parts(cell, plane);
            const Polytope back = part_of(cell, plane, -1), front = part_of(cell, plane, 1);
            EXPECT_NEAR(back.surface(), surfaces[0], 1e-9);
            EXPECT_NEAR(front.surface(), surfaces[1], 1e-9);
            EXPECT_GE(surfaces[0] + surfaces[1], cell.surface() - 1e-9);
            for (const Polytope &part : {back, front}) {
                Vec<double> sum(0);
                for (const Polygon &face : part.faces)
                    sum += vector_area(face);
                EXPECT_NEAR(length(sum), 0, 1e-9);
            }
            cell = surfaces[0] > surfaces[1] ? back : front;
            slanted += cell.faces.size() != 6;
        }
    }
    EXPECT_GT(slanted, 800); // such cells are no boxes
}

TEST(Bsp, APlaneThroughACellsCornersClosesBothParts) {
    const SplitPlane diagonal{{0.70710678f, -0.70710678f, 0}, 0};
    const Polytope cell = polytope_of(two_cube), half = part_of(cell, diagonal, 1);
    EXPECT_NEAR(half.surface(), 12 + 4 * std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(surfaces_of_parts(cell, diagonal)[1], half.surface(), 1e-6);
}

TEST(Bsp, WhatLiesInThePlaneGoesToTheEmptierSide) {
    const auto piece = [](float z0, float z1) {
        return Piece<Triangle<>>(Triangle<>{{0, 0, z0}, {1, 0, z1}, {0, 1, z1}}, Box<float>{});
    };
    const SplitPlane plane = plane_across({0, 0, 1}, {0, 0, 0});
    EXPECT_EQ(side_of(piece(0, 0), plane, 1e-6), within);
    EXPECT_EQ(side_of(piece(0, 1), plane, 1e-6), in_front);
    EXPECT_EQ(side_of(piece(-1, 0), plane, 1e-6), behind);
    EXPECT_EQ(side_of(piece(-1, 1), plane, 1e-6), both);
    const Census census{{3, 1, 2, 4}};
    EXPECT_FALSE(census.within_goes_behind());
    EXPECT_EQ(census.back(), 5u);
    EXPECT_EQ(census.front(), 7u);
}

// A box answers by its middle and its reach, a triangle by its corners: the box's answer is the wider one.
TEST(Bsp, ABoxReachesAsFarAsItsFarthestCorner) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec<float> lo(random_vector(random)), hi = lo + abs(Vec<float>(random_vector(random)));
        const SplitPlane plane = plane_across(random_vector(random), random_vector(random));
        Heights corners{infinity<double>, -infinity<double>};
        for (unsigned corner = 0; corner < 8; ++corner) {
            const double height =
                plane.height({corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z});
            corners = {std::min(corners.low, height), std::max(corners.high, height)};
        }
        const Heights heights = Piece<Box<>>(Box<>{lo, hi}, {lo, hi}).over(plane);
        EXPECT_NEAR(heights.low, corners.low, 1e-12);
        EXPECT_NEAR(heights.high, corners.high, 1e-12);
    }
}

BspPlanes planes_of(const std::vector<Triangle<>> &list, const BspRule &rule) {
    const std::span<const Triangle<>> given(list);
    const auto boxes = float_boxes(given);
    return BspBuilder<Triangle<>>(given, rule).build(boxes, can_be_hit(boxes), bounds(given));
}

// Behind the plane of any triangle of a convex body lie all the others.
TEST(Bsp, AutoPartitionOfAConvexBodyIsAList) {
    const auto convex = triangles(ball(2));
    const auto classical = planes_of(convex, {Planes::supporting, 1, 0, 1e9, 1 << 20});
    EXPECT_EQ(classical.depth, static_cast<int>(convex.size()) - 1);
    EXPECT_EQ(classical.entries.size(), convex.size());
    EXPECT_LE(planes_of(convex, {}).depth, 40);
}

TEST(Bsp, IsNoDeeperThanAWalkCanGo) {
    const auto convex = triangles(ball(3));
    const Bsp<Triangle<>> tree(std::span<const Triangle<>>(convex), {Planes::supporting, 1, 0, 1e9, 1 << 20});
    EXPECT_EQ(tree.planes.depth, deepest_bsp);
    EXPECT_TRUE(closest_hit(Ray<double>{{0, 0, 0}, {1, 2, 3}}, tree));
}

TEST(Bsp, EntriesAndDepthStayWithinTheRule) {
    Random random(4);
    std::vector<Triangle<>> list;
    for (int i = 0; i < 400; ++i)
        list.push_back(
            {Vec<float>(random_vector(random)), Vec<float>(random_vector(random)), Vec<float>(random_vector(random))});
    for (const double most : {1.0, 2.0, 6.0})
        EXPECT_LE(planes_of(list, {.node_cost = 0, .most_entries = most}).entries.size(), most * 400);
    EXPECT_LE(planes_of(list, {.deepest = 5}).depth, 5);
    EXPECT_EQ(planes_of(std::vector(100, list[0]), {.deepest = 0}).nodes.size(), 1u);
}

// Between tilted plates only a tilted plane can pass without cutting any.
TEST(Bsp, GeneralPlanesCutFewerShapes) {
    std::vector<Triangle<>> plates;
    for (int i = 0; i < 32; ++i) {
        const Vec<float> base(0, 0, 0.05f * static_cast<float>(i)), u(1, 0.2f, 0.7f), v(-0.3f, 1, 0.6f);
        plates.push_back({base, base + u, base + u + v});
        plates.push_back({base, base + u + v, base + v});
    }
    const auto entries = [&](Planes planes) {
        return planes_of(plates, {.planes = planes, .small_leaf = 1, .node_cost = 0}).entries.size();
    };
    EXPECT_LT(3 * entries(Planes::general), 2 * entries(Planes::axis_aligned));
}

} // namespace
