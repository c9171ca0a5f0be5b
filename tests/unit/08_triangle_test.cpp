// The mesh triangle: closed forms, ties, degenerate input, and scale.
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/08_mesh/triangle.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

#include <array>

using namespace course;

namespace {

const Triangle<> unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(Triangle, HitFromBothSides) {
    EXPECT_EQ(intersect(Ray<double>{{0.25, 0.25, 3}, {0, 0, -1}}, unit), 3.0);
    EXPECT_EQ(intersect(Ray<double>{{0.25, 0.25, -3}, {0, 0, 2}}, unit), 1.5);
    EXPECT_FALSE(intersect(Ray<double>{{0.25, 0.25, 3}, {0, 0, 1}}, unit));
    EXPECT_FALSE(intersect(Ray<double>{{0.75, 0.75, 3}, {0, 0, -1}}, unit));
}

TEST(Triangle, IntervalIsOpen) {
    EXPECT_FALSE(intersect(Ray<double>{{0.25, 0.25, 3}, {0, 0, -1}, 3}, unit));
    EXPECT_FALSE(intersect(Ray<double>{{0.25, 0.25, 3}, {0, 0, -1}, 0, 3}, unit));
}

TEST(Triangle, ARayInItsPlaneMisses) {
    EXPECT_FALSE(intersect(Ray<double>{{-1, 0.25, 0}, {1, 0, 0}}, unit));
    EXPECT_FALSE(intersect(Ray<double>{{-1, 0, 0}, {1, 0, 0}}, unit));
}

// Six triangles around a corner: a ray through the corner, or exactly along an edge's line, hits one of them.
TEST(Triangle, OneOfTheTrianglesAroundACornerIsHit) {
    Random random(7);
    for (int round = 0; round < 2000; ++round) {
        const auto lattice = [&] { return static_cast<float>(std::floor(random.uniform(-4, 5))); };
        const std::array<Vec<float>, 6> ring{{{3, 0, lattice()},
                                              {2, 3, lattice()},
                                              {-2, 2, lattice()},
                                              {-3, 0, lattice()},
                                              {-1, -3, lattice()},
                                              {2, -2, lattice()}}};
        const Vec<float> corner(0, 0, lattice());
        for (const Vec<double> aim :
             {Vec<double>(corner), Vec<double>(ring[0] + corner) / 2.0, Vec<double>(ring[4] + corner) / 2.0}) {
            const Ray<double> ray{aim + Vec<double>(0.0, 0.0, 32.0), {0, 0, -1}};
            int hits = 0;
            for (std::size_t i = 0; i < 6; ++i)
                hits += intersect(ray, Triangle<>{corner, ring[i], ring[(i + 1) % 6]}).has_value();
            EXPECT_EQ(hits, 1);
        }
    }
}

TEST(Triangle, WithoutAreaIsNeverHit) {
    Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const auto number = [&] { return static_cast<float>(random.uniform(-1, 1)); };
        const Vec<float> a(number(), number(), number());
        const Vec<float> b = a + 0.5f * (Vec<float>(number(), number(), number()) - a);
        // The coordinates of c = 2 b - a are floats, so the three corners lie on a line exactly only when nothing is
        // rounded; such triples are picked.
        const Vec<float> c = 2.0f * b - a;
        if (Vec<double>(c) != 2.0 * Vec<double>(b) - Vec<double>(a))
            continue;
        const Vec<double> origin(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
        EXPECT_FALSE(intersect(Ray<double>{origin, Vec<double>(b) - origin}, Triangle<>{a, b, c}));
        EXPECT_FALSE(intersect(Ray<double>{origin, Vec<double>(b) - origin}, Triangle<>{a, b, a}));
    }
}

TEST(Triangle, NothingStrangeIsAHit) {
    const double nan = std::nan(""), inf = infinity<double>;
    const float nan_f = std::nanf("");
    for (const double odd : {nan, inf, -inf})
        for (int i = 0; i < 3; ++i) {
            Ray<double> ray{{0.25, 0.25, 3}, {0, 0, -1}}, other = ray;
            ray.origin[i] = odd;
            other.direction[i] = odd;
            EXPECT_FALSE(intersect(ray, unit));
            EXPECT_FALSE(intersect(other, unit));
        }
    EXPECT_FALSE(intersect(Ray<double>{{0.25, 0.25, 3}, {0, 0, 0}}, unit));
    EXPECT_FALSE(intersect(Ray<double>{{0.25, 0.25, 3}, {0, 0, -1}}, Triangle<>{{0, 0, nan_f}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(Triangle, ScaleChangesNothing) {
    for (const float s : {1e-18f, 1e-6f, 1e-3f, 1.0f, 1e3f, 1e6f, 1e18f}) {
        const Triangle<> scaled{s * unit.a, s * unit.b, s * unit.c};
        const auto d = static_cast<double>(s);
        const auto t = intersect(Ray<double>{{0.25 * d, 0.25 * d, 3 * d}, {0, 0, -1}}, scaled);
        ASSERT_TRUE(t) << s;
        EXPECT_NEAR(*t / d, 3, 1e-14);
        EXPECT_FALSE(intersect(Ray<double>{{0.51 * d, 0.51 * d, 3 * d}, {0, 0, -1}}, scaled));
    }
}

TEST(Triangle, SurfacePointLiesInThePlaneAndNormalFollowsTheWinding) {
    const Triangle<> triangle{{1, 2, 3}, {4, 2, 2}, {1, 5, 7}};
    const Ray<double> ray{{2, 3, 20}, {0.01, 0.02, -1}};
    const auto t = intersect(ray, triangle);
    ASSERT_TRUE(t);
    const auto hit = surface(ray, *t, triangle);
    EXPECT_NEAR(dot(hit.normal, hit.point - Vec<double>(triangle.a)), 0, 1e-15);
    EXPECT_NEAR(length(hit.normal), 1, 1e-15);
    EXPECT_GT(hit.normal.z, 0);
}

} // namespace
