// The sphere's two forms against closed forms; the cross-product form where the textbook's fails.
#include "chapters/01_ray_casting/sphere.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

const Sphere<> unit_sphere{{0, 0, 0}, 1};

TEST(Sphere, HeadOnFromOutside) {
    const Ray<double> ray{{0, 0, 5}, {0, 0, -1}};
    EXPECT_EQ(intersect(ray, unit_sphere), 4.0);
    EXPECT_EQ(intersect_textbook(ray, unit_sphere), 4.0);
}

TEST(Sphere, FromInsideTheFarRootCounts) {
    const Ray<double> ray{{0.5, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(intersect(ray, unit_sphere), 0.5);
}

TEST(Sphere, BehindIsNoHit) { EXPECT_FALSE(intersect(Ray<double>{{0, 0, 5}, {0, 0, 1}}, unit_sphere)); }

TEST(Sphere, TangentTouchesOnce) { EXPECT_EQ(intersect(Ray<double>{{1, 0, 5}, {0, 0, -1}}, unit_sphere), 5.0); }

TEST(Sphere, DirectionNeedNotBeUnit) { EXPECT_EQ(intersect(Ray<double>{{0, 0, 5}, {0, 0, -2}}, unit_sphere), 2.0); }

TEST(Sphere, IntervalIsOpen) {
    EXPECT_EQ(intersect(Ray<double>{{0, 0, 5}, {0, 0, -1}, 4}, unit_sphere), 6.0);
    EXPECT_FALSE(intersect(Ray<double>{{0, 0, 5}, {0, 0, -1}, 0, 4}, unit_sphere));
}

// H1: a unit sphere 10,000 units away. In float the textbook form's b² and a c agree in every digit.
TEST(Sphere, TheTextbookInFloatLosesADistantSphere) {
    const Ray<float> ray{{0.6f, 0, 10000}, {0, 0, -1}};
    const float exact = 10000 - 0.8f;
    const auto textbook = intersect_textbook(ray, unit_sphere), stable = intersect(ray, unit_sphere);
    ASSERT_TRUE(stable);
    EXPECT_FLOAT_EQ(*stable, exact);
    EXPECT_TRUE(!textbook || std::abs(*textbook - exact) > 0.1f);
}

TEST(Sphere, SurfacePointLiesOnTheSphereAndNormalIsUnit) {
    const Sphere<> sphere{{1, -2, 3}, 0.75f};
    const Ray<double> ray{{5, 5, 5}, Vec<double>(1, -2, 3) - Vec<double>(5, 5, 5)};
    const auto t = intersect(ray, sphere);
    ASSERT_TRUE(t);
    const auto hit = surface(ray, *t, sphere);
    EXPECT_NEAR(length(hit.point - Vec<double>(sphere.centre)), 0.75, 1e-15);
    EXPECT_NEAR(length(hit.normal), 1, 1e-15);
}

} // namespace
