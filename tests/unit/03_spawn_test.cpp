// Spawned rays: none meets its own surface again, none slips past a neighbour, on every shape and at ten scales.
#include "chapters/03_light_and_shadow/any_hit.hpp"
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

constexpr int rays_per_cell = 2000;

Vec<double> random_vector(Random &random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// One of each shape, some `size` big, around `place`.
template <class Shape> Shape make(const Vec<double> &place, double size, Random &random);

template <> Sphere<> make(const Vec<double> &place, double size, Random &) {
    return {Vec<float>(place), static_cast<float>(size)};
}
template <> Plane<> make(const Vec<double> &place, double, Random &random) {
    return {Vec<float>(place), Vec<float>(random_vector(random))};
}
template <> Disk<> make(const Vec<double> &place, double size, Random &random) {
    return {Vec<float>(place), Vec<float>(random_vector(random)), static_cast<float>(size)};
}
template <> AffineTriangle<> make(const Vec<double> &place, double size, Random &random) {
    return affine_triangle(Vec<float>(place + size * random_vector(random)),
                           Vec<float>(place + size * random_vector(random)),
                           Vec<float>(place + size * random_vector(random)));
}
template <> Cylinder<> make(const Vec<double> &place, double size, Random &random) {
    const Vec<double> axis = size * random_vector(random);
    return {Vec<float>(place - axis), Vec<float>(place + axis), static_cast<float>(0.5 * size)};
}
template <> Cone<> make(const Vec<double> &place, double size, Random &random) {
    const Vec<double> axis = size * random_vector(random);
    return {Vec<float>(place - axis), Vec<float>(place + axis), static_cast<float>(0.7 * size)};
}
template <> Box<> make(const Vec<double> &place, double size, Random &random) {
    const Vec<double> half = size * (0.2 + 0.8 * abs(random_vector(random)));
    return {Vec<float>(place - half), Vec<float>(place + half)};
}

// Calls f(shape, surface, incoming direction) for many random hits, from outside and from inside, at ten scales, two
// sizes and a hundred sizes away from the origin.
template <class Shape, class F> void for_random_hits(F &&f) {
    Random random(7);
    for (int exponent = -3; exponent <= 6; ++exponent)
        for (const double away : {2.0, 100.0}) {
            const double size = std::pow(10.0, exponent);
            const Vec<double> place = away * size * Vec<double>(0.6, -0.64, 0.48);
            int hits = 0;
            for (int i = 0; i < 20 * rays_per_cell && hits < rays_per_cell; ++i) {
                const auto shape = make<Shape>(place, size, random);
                const double from = i % 2 ? 3 : 0.3;
                const Vec<double> origin = place + from * size * random_vector(random);
                const Ray<double> ray{origin, place + size * random_vector(random) - origin};
                if (const auto t = intersect(ray, shape)) {
                    ++hits;
                    f(shape, surface(ray, *t, shape), size, random);
                }
            }
            ASSERT_EQ(hits, rays_per_cell);
        }
}

// A direction at the angle to the normal whose cosine is given (its sign says to which side).
Vec<double> leaving(const Vec<double> &normal, double cosine, Random &random) {
    const Vec<double> tangent = normalize(cross(normal, random_vector(random)));
    return cosine * normal + std::sqrt(1 - cosine * cosine) * tangent;
}

// Cosines from steep to so grazing that the ray all but runs within the surface.
double some_cosine(Random &random) {
    return random.uniform() < 0.5 ? random.uniform(0.02, 1) : std::pow(10.0, random.uniform(-7, -1));
}

template <class Shape> struct Spawn : testing::Test {};
using Shapes = testing::Types<Sphere<>, Plane<>, Disk<>, AffineTriangle<>, Cylinder<>, Cone<>, Box<>>;
TYPED_TEST_SUITE(Spawn, Shapes);

// Every shape here bounds a convex body or is flat: what leaves it outwards never meets it again.
TYPED_TEST(Spawn, OutwardsItNeverMeetsItsOwnShape) {
    int acne = 0;
    for_random_hits<TypeParam>([&](const auto &shape, const auto &surface, double, Random &random) {
        acne += any_hit(spawn_ray(surface, leaving(surface.normal, some_cosine(random), random)), shape);
    });
    EXPECT_EQ(acne, 0);
}

// What goes inwards may meet the far wall, from inside; it must not meet the wall that it has just come through.
TYPED_TEST(Spawn, InwardsItMeetsOnlyTheFarSide) {
    int acne = 0;
    for_random_hits<TypeParam>([&](const auto &shape, const auto &at, double, Random &random) {
        const auto ray = spawn_ray(at, leaving(at.normal, -some_cosine(random), random));
        if (const auto t = intersect(ray, shape))
            acne += dot(surface(ray, *t, shape).normal, ray.direction) < 0;
    });
    EXPECT_EQ(acne, 0);
}

// A wall stands a small gap before the surface. Gaps below 64 ulp of a float coordinate are no scene's intention.
TYPED_TEST(Spawn, ItDoesNotSlipPastANeighbour) {
    int leaks = 0;
    for_random_hits<TypeParam>([&](const auto &, const auto &surface, double size, Random &random) {
        for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5}) {
            const Plane<double> wall{surface.point + gap * size * surface.normal, surface.normal};
            if (gap * size < 64 * 0x1p-23 * norm_1(surface.point))
                continue;
            leaks += !any_hit(spawn_ray(surface, leaving(surface.normal, some_cosine(random), random)), wall);
        }
    });
    EXPECT_EQ(leaks, 0);
}

// The last bound must be small for another reason: light that comes through a gap must not be lost. It is far below
// what a float coordinate can even express.
TYPED_TEST(Spawn, TheOffsetIsFarBelowAFloatsLastBit) {
    for_random_hits<TypeParam>([&](const auto &shape, const auto &surface, double size, Random &) {
        EXPECT_LT(spawn_offset(shape, surface.point), 0x1p-40 * (norm_1(surface.point) + 8 * size));
    });
}

// What the tests above would miss must show: the same rays from where rounding leaves them, without the offset.
TYPED_TEST(Spawn, WithoutTheOffsetTheyStick) {
    int acne = 0;
    for_random_hits<TypeParam>([&](const auto &shape, const auto &surface, double, Random &random) {
        const Vec<double> direction = leaving(surface.normal, some_cosine(random), random);
        acne += any_hit(Ray<double>{surface.point, direction}, shape);
    });
    if (!std::is_same_v<TypeParam, Box<>>) { // the box's surface() puts the point on its face exactly
        EXPECT_GT(acne, 100);
    }
}

// Note A's constant offset suits one scale: at ten thousand it sticks, at a thousandth it slips past.
TEST(ConstantOffset, SuitsOneScaleOnly) {
    const auto count = [](double size) {
        Random random(5);
        const Sphere<> sphere{Vec<float>(2 * size * Vec<double>(0.6, -0.64, 0.48)), static_cast<float>(size)};
        const Sphere<> shell{sphere.centre, static_cast<float>(1.001 * size)};
        int acne = 0, leaks = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec<double> direction = normalize(random_vector(random));
            const Ray<float> ray{sphere.centre - static_cast<float>(3 * size) * Vec<float>(direction),
                                 Vec<float>(direction)};
            const auto t = intersect(ray, sphere);
            if (!t)
                continue;
            const auto at = surface(ray, *t, sphere);
            const auto spawned =
                ConstantOffset{ray, *t, 1e-4f}(at, leaving(Vec<double>(at.normal), 0.5, random), infinity<double>);
            acne += any_hit(spawned, sphere);
            leaks += !any_hit(spawned, shell) ||
                     dot(spawned.origin - shell.centre, spawned.origin - shell.centre) > shell.radius * shell.radius;
        }
        return std::pair{acne, leaks};
    };
    EXPECT_EQ(count(1), (std::pair{0, 0}));
    EXPECT_GT(count(10000).first, 100);
    EXPECT_GT(count(0.001).second, 100);
}

} // namespace
