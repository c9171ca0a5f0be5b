// Formulas that cannot be right as they are printed: each fails here, and the derived one holds on the same rays.
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/errata_tally.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

using V = Vec<double>;
const Cylinder<> &cylinder = tally_cylinder; // upright, from z = 0 to 4, radius 1
const Cone<> &cone = tally_cone;             // upright, from the apex at z = 0 to 2, radius z / 2

Ray<double> towards(const V &from, const V &to) { return {from, normalize(to - from)}; }

TEST(EquationA34Cylinder, AsPrintedHoldsOnlyAcrossTheAxis) {
    const auto printed = [](const auto &ray) { return intersect_as_printed(ray, cylinder); };
    EXPECT_EQ(tally(printed, off_cylinder, true).right, 10000) << "n0 · n = 0: nothing to see";
    const Tally slanted = tally(printed, off_cylinder);
    EXPECT_LT(slanted.right, 100);
    EXPECT_GT(slanted.elsewhere, 1000) << "points reported that are not on the cylinder";
}

TEST(EquationA34Cylinder, DerivedHoldsOnEveryRay) {
    EXPECT_EQ(tally([](const auto &ray) { return intersect(ray, cylinder); }, off_cylinder).right, 10000);
    EXPECT_EQ(tally([](const auto &ray) { return intersect_textbook(ray, cylinder); }, off_cylinder).right, 10000);
}

// By hand: from (-5, 0, 0.5) along (0.8, 0, 0.6) the side x = -1 is met at t = 4 / 0.8 = 5, at height 3.5.
TEST(EquationA34Cylinder, ByHand) {
    const Ray<double> ray{{-5, 0, 0.5}, {0.8, 0, 0.6}};
    EXPECT_DOUBLE_EQ(intersect(ray, cylinder).value(), 5);
    const auto printed = intersect_as_printed(ray, cylinder);
    EXPECT_TRUE(!printed || std::abs(*printed - 5) > 1);
}

TEST(EquationA40Cone, AsPrintedHoldsOnlyAcrossTheAxis) {
    const auto printed = [](const auto &ray) { return intersect_as_printed(ray, cone); };
    const Tally across = tally(printed, off_cone, true), slanted = tally(printed, off_cone);
    EXPECT_EQ(across.right + across.elsewhere, 10000);
    EXPECT_EQ(across.elsewhere, 0);
    EXPECT_LT(slanted.right, 100);
}

TEST(EquationA40Cone, DerivedHoldsOnEveryRay) {
    EXPECT_EQ(tally([](const auto &ray) { return intersect(ray, cone); }, off_cone).right, 10000);
    EXPECT_EQ(tally([](const auto &ray) { return intersect_textbook(ray, cone); }, off_cone).right, 10000);
}

// Steeper than the side: the mirror image at z = -1 comes first, the cone at z = 3/7 after it.
TEST(EquationsA11A12Cone, TheNearestRootMayBelongToTheMirrorImage) {
    const Ray<double> ray = towards({-0.9, 0, -3}, {0.1, 0, 2});
    EXPECT_FALSE(intersect_nearest_first(ray, cone));
    const auto t = intersect(ray, cone);
    ASSERT_TRUE(t);
    EXPECT_NEAR(point_at(ray, *t).z, 3.0 / 7, 1e-15);
}

// Eq. 11 squared holds on the mirror image too: only the lower bound of eq. 12 tells the two apart.
TEST(EquationsA11A12Cone, WithoutTheLowerBoundTheMirrorImageIsHit) {
    const Ray<double> ray{{-5, 0, -1}, {1, 0, 0}};
    const auto roots = cone_roots_as_printed(ray, cone, true);
    EXPECT_DOUBLE_EQ(std::min(roots.first, roots.second), 4.5);
    EXPECT_FALSE(intersect(ray, cone));
}

// Where the ray is flatter than the side, eq. 42's a is negative and its t1 the farther root.
TEST(EquationsA36A42, TheRootsChangePlacesWhereAIsNegative) {
    const Ray<double> ray{{-5, 0, 1}, {1, 0, 0}};
    const auto roots = cone_roots_as_printed(ray, cone, true);
    EXPECT_DOUBLE_EQ(roots.first, 5.5);
    EXPECT_DOUBLE_EQ(roots.second, 4.5);
    EXPECT_DOUBLE_EQ(intersect_first_root_first(ray, cone).value(), 5.5) << "the far side";
    EXPECT_DOUBLE_EQ(intersect(ray, cone).value(), 4.5);
    EXPECT_DOUBLE_EQ(intersect_textbook(ray, cone).value(), 4.5);
}

// Parallel to a generator of a cone with a right angle at the apex, a is 0 exactly, and the printed roots are
// -infinity and 0 / 0.
TEST(EquationsA36A42, AlongAGeneratorTheDivisionByAFails) {
    const Cone<> right_angled{{0, 0, 0}, {0, 0, 1}, 1};
    const Ray<double> ray{{-0.5, 0, 0}, {1, 0, 1}}; // x = z - 0.5 meets x = -z at z = 0.25
    EXPECT_FALSE(intersect_textbook(ray, right_angled));
    EXPECT_EQ(intersect(ray, right_angled), 0.25);
}

TEST(EquationsA36A42, AlongTheAxisOfACylinderThereIsNoRoot) {
    for (const double x : {0.0, 0.5, 1.0, 2.0}) {
        const Ray<double> ray{{x, 0, -1}, {0, 0, 1}};
        EXPECT_FALSE(intersect(ray, cylinder));
        EXPECT_FALSE(intersect_textbook(ray, cylinder));
    }
}

// A 3.1.4: far from the origin, n · p + W subtracts two large numbers. The plane z = x through a point at 1e6 is missed
// by more than a tenth in float.
TEST(EquationA16Plane, StoringWCancelsFarFromTheOrigin) {
    const Plane<> plane{{1000000, 0, 1000000.25f}, {1, 0, -1}};
    const Ray<float> ray{{1000000, 0, 1000003.25f}, {0, 0, -1}};
    EXPECT_EQ(intersect(ray, plane), 3.0f);
    const Plane<> tilted{{1000000, 0, 1000000.25f}, {0.7f, 0.1f, -0.71f}};
    const double exact = static_cast<double>(intersect(ray, tilted).value());
    EXPECT_NEAR(exact, 3, 1e-6);
    const auto textbook = intersect_textbook(ray, tilted);
    EXPECT_TRUE(!textbook || std::abs(static_cast<double>(*textbook) - exact) > 0.01);
}

} // namespace
