// Mirrors, glow and sums; the bounce limit; the early end; the picture against double geometry.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/06_whitted/mirror_scene.hpp"
#include "common/image_difference.hpp"
#include "common/image_files.hpp"
#include "tests/unit/widened.hpp"

#include <cstdio>
#include <gtest/gtest.h>

using namespace course;

namespace {

Vec<double> random_direction(Random &random) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

const Lights<> no_lights;

TEST(MirrorDirection, TurnsTheNormalPartAndKeepsTheRest) {
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const Vec<double> d = 3.0 * random_direction(random), n = random_direction(random), m = mirror_direction(d, n);
        EXPECT_NEAR(dot(m, n), -dot(d, n), 1e-14);
        EXPECT_LT(length(cross(m - d, n)), 1e-14);
        EXPECT_NEAR(length(m), 3, 1e-14);
        EXPECT_LT(length(mirror_direction(m, n) - d), 1e-14);       // its own inverse
        EXPECT_EQ(mirror_direction(d, n), mirror_direction(d, -n)); // either side
    }
}

// Two mirrors of reflectance 0.5 and a glow behind a chain of known length: the light is 0.5 to the number of bounces.
TEST(Whitted, EachBounceTakesItsShare) {
    const World world{Scene(std::vector{Object<Plane<>, Mirror<>>{{{0, 0, -1}, {0, 0, 1}}, {Colour(0.5f)}},
                                        Object<Plane<>, Mirror<>>{{{0, 0, 1}, {0, 0, -1}}, {Colour(0.5f)}}},
                            std::vector{Object<Plane<>, Glow<>>{{{10, 0, 0}, {-1, 0, 0}}, {Colour(1, 2, 4)}}}),
                      no_lights, ConstantSky{Colour(9)}};
    Random random(1);
    for (int bounces = 0; bounces <= 16; ++bounces) { // moves on by 2 along z per bounce, by 10 along x in all
        const Ray<double> ray{{0, 0, 0}, {10, 0, 2.0 * bounces}};
        const float share = std::ldexp(1.0f, -bounces);
        EXPECT_EQ(radiance(ray, world, Path{}, random), share * Colour(1, 2, 4)) << bounces;
    }
}

TEST(Whitted, ALimitCutsOffWhatLiesBeyond) {
    World world{Scene(std::vector{Object<Plane<>, Mirror<>>{{{0, 0, 0}, {0, 1, 0}}, {Colour(1)}}}), no_lights,
                ConstantSky{Colour(1)}};
    Random random(1);
    const Ray<double> down{{0, 1, 0}, {0, -1, 0}};
    world.limits.bounces = 0;
    EXPECT_EQ(radiance(down, world, Path{}, random), Colour(0));
    world.limits.bounces = 1;
    EXPECT_EQ(radiance(down, world, Path{}, random), Colour(1));
}

// A ray between two exactly parallel mirrors would never end.
TEST(Whitted, ATrappedRayEndsByItsWeight) {
    World world{Scene(std::vector{Object<Plane<>, Mirror<>>{{{0, 0, -1}, {0, 0, 1}}, {Colour(0.9f)}},
                                  Object<Plane<>, Mirror<>>{{{0, 0, 1}, {0, 0, -1}}, {Colour(0.9f)}}}),
                no_lights, ConstantSky{Colour(1)}, Limits{.bounces = 1000000}};
    Random random(1);
    const std::uint64_t before = rays_of_this_thread;
    EXPECT_EQ(radiance(Ray<double>{{0, 0, 0}, {0, 0, 1}}, world, Path{}, random), Colour(0));
    const double bounces = std::log(std::ldexp(1, -16)) / std::log(0.9);
    EXPECT_NEAR(static_cast<double>(rays_of_this_thread - before), bounces, 2);
}

TEST(Whitted, ASumAddsItsParts) {
    const Plane<> floor{{0, 0, 0}, {0, 1, 0}};
    const World world{Scene(std::vector{Object<Plane<>, Sum<Glow<>, Mirror<Checker>>>{
                          floor, Sum(Glow<>{Colour(0.25f)}, Mirror<Checker>{{Colour(0.5f), Colour(0)}})}}),
                      no_lights, ConstantSky{Colour(1)}};
    Random random(1);
    EXPECT_EQ(radiance(Ray<double>{{0.5, 1, -0.5}, {0, -1, 0}}, world, Path{}, random), Colour(0.75f));
    EXPECT_EQ(radiance(Ray<double>{{1.5, 1, -0.5}, {0, -1, 0}}, world, Path{}, random), Colour(0.25f));
}

TEST(Whitted, AnEmptySceneShowsTheSky) {
    const World world{Scene<Object<Sphere<>, Mirror<>>>({}), no_lights, ConstantSky{Colour(0.3f)}};
    Random random(1);
    EXPECT_EQ(radiance(Ray<double>{{0, 0, 0}, {0, 0, 1}}, world, Path{}, random), Colour(0.3f));
}

Picture render(const auto &world, int width, int height) {
    const Camera camera(mirror_view(), width, height);
    return render_picture("test", width, height, each_pixel([&](int x, int y) {
                              Random random(1);
                              return radiance(camera.ray(x + 0.5, y + 0.5), world, Path{}, random);
                          }))
        .picture;
}

// Ending rays by their weight changes no pixel of 8 bits.
TEST(Whitted, TheEarlyEndChangesNoPixel) {
    const auto changed = [](auto world) {
        world.limits = {.bounces = 400, .least_weight = 0};
        const Picture patient = render(world, 192, 108);
        world.limits.least_weight = Limits{}.least_weight;
        const Picture early = render(world, 192, 108);
        int pixels = 0;
        for (std::size_t i = 0; i < early.pixels.size(); ++i)
            for (int channel = 0; channel < 3; ++channel)
                pixels += srgb_byte(early.pixels[i][channel]) != srgb_byte(patient.pixels[i][channel]);
        return pixels;
    };
    EXPECT_EQ(changed(mirror_world()), 0);
    EXPECT_EQ(changed(closed_room()), 0);
}

TEST(MirrorScene, LooksAsItDoesInDouble) {
    const auto world = mirror_world();
    const World wide{widened(world.scene), world.lights, world.sky, world.limits};
    const double rmse = difference(render(world, 192, 108), render(wide, 192, 108)).rmse;
    std::printf("06_whitted: RMSE %.2g to the same scene in double (1/255 = %.2g allowed)\n", rmse, 1.0 / 255);
    EXPECT_LT(rmse, 1.0 / 255);
}

} // namespace
