// Glass, liquids and bubbles in whole scenes: energy, absorption, total reflection, what a scene's type holds.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/06_whitted/mirror_scene.hpp"
#include "chapters/07_glass/everything.hpp"
#include "chapters/07_glass/glass_scenes.hpp"
#include "chapters/07_glass/holds.hpp"
#include "common/image_difference.hpp"
#include "tests/unit/widened.hpp"

#include <cstdio>
#include <gtest/gtest.h>

namespace course {
inline Annulus<double> widened(const Annulus<> &a) { return {widened(a.disk), a.hole}; }
} // namespace course

using namespace course;

namespace {

const Lights<> no_lights;
const ConstantSky white{Colour(1)};

TEST(Holds, GlassIsFoundWhereverItIs) {
    using Ball = Sphere<>;
    static_assert(holds<Scene<Object<Ball, Pane>>, Dielectric>);
    static_assert(holds<Scene<Object<Ball, Diffuse<>>, Object<Ball, Sum<Diffuse<>, Pane>>>, Dielectric>);
    static_assert(!holds<Scene<Object<Ball, Diffuse<>>, Object<Ball, Sum<Glow<>, Mirror<>>>>, Dielectric>);
    static_assert(holds<decltype(mirror_world()), Mirror> && !holds<decltype(mirror_world()), Dielectric>);
    static_assert(holds<decltype(whitted_world()), Dielectric> && !holds<decltype(whitted_world()), Tinted>);
}

TEST(Annulus, HasAHoleAndARim) {
    const Annulus<> ring{{{0, 0, 0}, {0, 1, 0}, 2}, 1};
    const auto hit = [&](double x) { return intersect(Ray<double>{{x, 1, 0}, {0, -1, 0}}, ring); };
    EXPECT_FALSE(hit(0.5));
    EXPECT_EQ(hit(1), 1.0);
    EXPECT_EQ(hit(1.5), 1.0);
    EXPECT_EQ(hit(2), 1.0);
    EXPECT_FALSE(hit(2.5));
}

// Straight through a ball of nothing but tint: exp(-absorption times diameter), and half of it from the middle.
TEST(Absorption, CountsTheLengthInside) {
    const Tinted<> smoke{1, {0.5f, 1, 2}};
    const World world{Scene(std::vector{Object<Sphere<>, DrinkInside>{{{0, 0, 0}, 1}, {smoke, air, {}, {}}}}),
                      no_lights, white};
    Random random(1);
    for (const auto &[start, way] : {std::pair{5.0, 2.0f}, {0.0, 1.0f}}) {
        const Colour found = radiance(Ray<double>{{0, 0, start}, {0, 0, -3}}, world, Path{}, random);
        EXPECT_LT(length(found - exp(-way * smoke.absorption)), 1e-6);
    }
}

// A plane of glass seen straight on mirrors ((n - 1) / (n + 1))² of a glow before it and passes the rest from behind.
TEST(Dielectric, DividesLightByFresnel) {
    const World world{Scene(std::vector{Object<Plane<>, Pane>{{{0, 0, 0}, {0, 0, 1}}, {glass, air, {}, {}}}},
                            std::vector{Object<Plane<>, Glow<>>{{{0, 0, 9}, {0, 0, 1}}, {Colour(1, 0, 0)}},
                                        Object<Plane<>, Glow<>>{{{0, 0, -9}, {0, 0, 1}}, {Colour(0, 1, 0)}}}),
                      no_lights, white};
    Random random(1);
    const Colour found = radiance(Ray<double>{{0, 0, 5}, {0, 0, -1}}, world, Path{}, random);
    EXPECT_NEAR(found.r, 0.04, 1e-6);
    EXPECT_NEAR(found.g, 0.96, 1e-6);
}

// A texture drives the index: where it is black the pane has the index of air and mirrors nothing.
TEST(Dielectric, ATextureDrivesTheIndex) {
    using Patterned = Clear<Scaled<Checker>>;
    const Patterned pattern{{{Colour(1), Colour(0)}, 1.0f, 1.5f}};
    const World world{
        Scene(std::vector{Object<Plane<>, Dielectric<Patterned>>{{{0, 0, 0}, {0, 0, 1}}, {pattern, air, {}, {}}}},
              std::vector{Object<Plane<>, Glow<>>{{{0, 0, 9}, {0, 0, 1}}, {Colour(1, 0, 0)}}}),
        no_lights, ConstantSky{Colour(0)}};
    Random random(1);
    EXPECT_NEAR(radiance(Ray<double>{{0.5, 0.5, 5}, {0, 0, -1}}, world, Path{}, random).r, 0.04, 1e-6);
    EXPECT_NEAR(radiance(Ray<double>{{1.5, 0.5, 5}, {0, 0, -1}}, world, Path{}, random).r, 0, 1e-12);
}

// Glass around a bubble: a ray that passes the bubble's middle at more than R / n is totally reflected by it.
TEST(Bubble, ReflectsTotallyNearItsRim) {
    const Object<Sphere<>, Pane> ball{{{0, 0, 0}, 2}, {glass, air, {}, {}}},
        bubble{{{0, 0, 0}, 1}, {air, glass, {}, {}}};
    const Object<Sphere<>, Glow<>> lamp{{{0, 0, 0}, 0.5f}, {Colour(1)}}; // seen only by what enters the bubble
    const World world{Scene(std::vector{ball, bubble}, std::vector{lamp}), no_lights, ConstantSky{Colour(0)}};
    Random random(1);
    const auto seen_from_glass = [&](double off) {
        return radiance(Ray<double>{{off, 0, 1.5}, {0, 0, -1}}, world, Path{}, random).r;
    };
    EXPECT_GT(seen_from_glass(0.2), 0.9);
    EXPECT_EQ(seen_from_glass(1 / 1.5 + 1e-6), 0);
    EXPECT_GT(fresnel(std::sqrt(1 - 0.6 * 0.6), 1.5f, 1).transmitted, 0); // and just within R / n it is not
}

// The closed white furnace: whatever clear glass and perfect mirrors stand in surroundings that glow with 1 everywhere,
// every ray brings 1, short of what the limits cut off.
double darkest(const auto &world, const Viewpoint &view) {
    double least = 1, most = 0;
    const Camera camera(view, 48, 27);
    for (int y = 0; y < 27; ++y)
        for (int x = 0; x < 48; ++x) {
            Random random(1);
            const auto found = static_cast<double>(radiance(camera.ray(x + 0.5, y + 0.5), world, Path{}, random).g);
            least = std::min(least, found), most = std::max(most, found);
        }
    EXPECT_LT(most, 1 + 1e-5);
    return least;
}

TEST(Furnace, StaysWhiteAsTheBounceLimitGrows) {
    const Object<Sphere<>, Glow<>> surroundings{{{0, 0, 0}, 50}, {Colour(1)}};
    World balls{Scene(std::vector{surroundings},
                      std::vector{Object<Sphere<>, Pane>{{{-0.8f, 0, 0}, 1}, {glass, air, {}, {}}},
                                  Object<Sphere<>, Pane>{{{-0.7f, 0.1f, 0.2f}, 0.5f}, {air, glass, {}, {}}}},
                      std::vector{Object<Sphere<>, Mirror<>>{{{1.2f, 0, -0.5f}, 0.9f}, {Colour(1)}}},
                      std::vector{Object<Box<>, Mirror<>>{{{-2, -1.6f, -2}, {2, -1.2f, 2}}, {Colour(1)}}}),
                no_lights, ConstantSky{Colour(0)}};
    double before = 1, error = 0;
    for (const int bounces : {4, 8, 16, 32, 64}) {
        balls.limits = {.bounces = bounces, .least_weight = 0x1p-26f};
        error = 1 - darkest(balls, {.eye = {0, 0.5, 5}});
        std::printf("furnace, glass, bubble and mirrors: %2d bounces, darkest pixel 1 - %.2g\n", bounces, error);
        EXPECT_LE(error, before);
        before = error;
    }
    EXPECT_LT(error, 1e-4);
}

// In a tumbler's wall some light goes round for hundreds of bounces. So nothing may be lost but what the limits cut
// off: if that is taken to be white as well, all is white, at any limit.
TEST(Furnace, NothingIsLostInATumblerOfWaterWithBubbles) {
    const Object<Plane<>, Mirror<>> table{{{0, 0, 0}, {0, 1, 0}}, {Colour(1)}};
    auto world = drink_world(water, table, white);
    for (const int bounces : {3, 10, 60}) {
        world.limits = {bounces, 0x1p-16f, Colour(1)};
        const double error = 1 - darkest(world, drink_view());
        std::printf("furnace, tumbler of water: %d bounces, white beyond: darkest pixel 1 - %.2g\n", bounces, error);
        EXPECT_LT(error, 1e-5);
    }
}

Picture render(const auto &world, const Viewpoint &view) {
    const Camera camera(view, 128, 72);
    return render_picture("test", 128, 72, each_pixel([&](int x, int y) {
                              Random random(1);
                              return radiance(camera.ray(x + 0.5, y + 0.5), world, Path{}, random);
                          }))
        .picture;
}

static_assert(sizeof(Object<Sphere<>, Mirror<>>) == 28 && sizeof(Object<Sphere<>, Everything>) == 176);

TEST(Everything, ShowsTheSame) {
    auto world = whitted_world();
    world.limits.least_weight = 0x1p-12f;
    EXPECT_LT(difference(render(world, whitted_view()), render(with_everything(world), whitted_view())).largest, 1e-6);
}

TEST(GlassScenes, LookAsTheyDoInDouble) {
    const auto compare = [](const char *name, auto world, const Viewpoint &view) {
        world.limits.least_weight = 0x1p-12f;
        const World wide{widened(world.scene), world.lights, world.sky, world.limits};
        const double rmse = difference(render(world, view), render(wide, view)).rmse;
        std::printf("07_glass, %s: RMSE %.2g to the same scene in double (1/255 = %.2g allowed)\n", name, rmse,
                    1.0 / 255);
        EXPECT_LT(rmse, 1.0 / 255);
    };
    compare("Whitted's spheres", whitted_world(), whitted_view());
    const Object<Plane<>, Diffuse<>> table{{{0, 0, 0}, {0, 1, 0}}, {Colour(0.7f)}};
    compare("drink", drink_world(juice, table, white), drink_view());
}

} // namespace
