// The shadow map against closed forms: depths, comparisons, what the bias must be, what the filter can and cannot do.
#include "chapters/04_shadow_map/measure.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

const Viewpoint above{.eye = {0, 5, 0}, .target = {0, 0, 0}, .up = {0, 0, 1}, .field_of_view = 60};
const Plane<> floor_plane{{0, 0, 0}, {0, 1, 0}};
const Vec<double> upwards(0, 1, 0);

TEST(LightView, FindsThePlaceOfAPointOnItsRay) {
    const LightView view({.eye = {3, 4, -2}, .target = {0, 1, 0}, .field_of_view = 50});
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform(), y = random.uniform(), depth = random.uniform(0.1, 20);
        const SeenPlace place = view.place_of(point_at(view.ray(x, y), depth));
        EXPECT_NEAR(place.x, x, 1e-13);
        EXPECT_NEAR(place.y, y, 1e-13);
        EXPECT_NEAR(place.depth, depth, 1e-13);
        EXPECT_TRUE(place.in_picture());
    }
    EXPECT_FALSE(view.place_of({6, 7, -4}).in_picture()); // behind the lamp
}

TEST(DepthImage, HoldsTheDepthOfAFloorAndOfABox) {
    const Scene<Plane<>, Box<>> scene({floor_plane}, {Box<>{{-0.5f, 0, -0.5f}, {0.5f, 1.5f, 0.5f}}});
    const auto depths = depth_image(scene, LightView(above), 64);
    EXPECT_EQ(depths(0, 0), 5.0f); // the depth along the line of sight, not the length of the ray
    EXPECT_EQ(depths(63, 20), 5.0f);
    EXPECT_EQ(depths(32, 32), 3.5f);
    const auto empty = depth_image(Scene(std::vector<Sphere<>>{}), LightView(above), 4);
    EXPECT_EQ(empty(1, 2), infinity<float>);
}

TEST(ShadowMap, ShadesWhatLiesBehindSomething) {
    const Scene<Plane<>, Box<>> scene({floor_plane}, {Box<>{{-0.5f, 2, -0.5f}, {0.5f, 2.5f, 0.5f}}});
    const ShadowMap map(scene, LightView(above), 128);
    for (const int filter : {0, 2}) {
        EXPECT_EQ(map.lit({0, 0, 0}, upwards, {.filter = filter}), 0);
        EXPECT_EQ(map.lit({0, 2.5, 0}, upwards, {.filter = filter}), 1); // the box's own top
        EXPECT_EQ(map.lit({1.5, 0, 0}, upwards, {.filter = filter}), 1);
    }
    EXPECT_EQ(map.lit({50, 0, 0}, upwards, {}), 1); // the lamp has not looked there
    EXPECT_EQ(map.lit({0, 9, 0}, upwards, {}), 1);
}

// Nothing shades a lone plane. A point lies at most half a texel to the side and half a texel up from the middle of its
// texel, so a slope of a half is enough but for the bend of perspective.
TEST(ShadowMap, TheSlopeLeavesNoAcneOnAPlane) {
    for (const double degrees : {0.0, 20.0, 45.0, 60.0, 70.0}) {
        const double angle = degrees * pi / 180;
        const Plane<> plane{{0, 0, 0}, Vec<float>(std::sin(angle), std::cos(angle), 0)};
        const Vec<double> normal = normalize(Vec<double>(plane.normal));
        const ShadowMap map(Scene(std::vector{plane}), LightView(above), 64);
        int wrong_with = 0, wrong_with_less = 0, wrong_filtered = 0, wrong_without = 0;
        Random random(2);
        for (int i = 0; i < 4000; ++i) {
            const Ray<double> ray = map.view().ray(random.uniform(0.3, 0.7), random.uniform(0.3, 0.7));
            const auto t = intersect(ray, plane);
            ASSERT_TRUE(t);
            const Vec<double> point = surface(ray, *t, plane).point;
            wrong_with += map.lit(point, normal, {}) < 1;
            wrong_filtered += map.lit(point, normal, {.filter = 2}) < 1;
            wrong_with_less += map.lit(point, normal, {.slope = 0.4}) < 1;
            wrong_without += map.lit(point, normal, {.slope = 0}) < 1;
        }
        EXPECT_EQ(wrong_with, 0) << degrees;
        EXPECT_EQ(wrong_filtered, 0) << degrees;
        if (degrees > 0) {
            EXPECT_GT(wrong_with_less, 0) << degrees;
            EXPECT_GT(wrong_without, 1000) << degrees; // about half
        }
    }
}

// Under a roof's edge the filter of radius f gives a ramp of 2 f + 1 texels in steps of 1 / (2 f + 1); without, a step.
TEST(ShadowMap, TheFilterMakesARampOfItsOwnWidth) {
    const Scene<Box<>, Plane<>> scene({Box<>{{0, 1, -9}, {9, 1, 9}}}, {floor_plane});
    const LightView view(above);
    const ShadowMap map(scene, view, 256);
    const double texel = view.width_at(5) / 256;
    for (const int filter : {0, 1, 3}) {
        const auto lit = [&](const Vec<double> &place) { return map.lit(place, upwards, {.filter = filter}); };
        EXPECT_NEAR(width_of_penumbra(lit), filter ? 2 * filter * texel : 0, 2e-3) << filter;
        for (double x = -0.5; x < 0.5; x += 0.003) {
            const double steps = static_cast<double>(lit({x, 0, 0.005})) * (2 * filter + 1);
            EXPECT_NEAR(steps, std::round(steps), 1e-5);
        }
    }
}

// C19: the penumbra of a lamp grows with the height of the edge; the filter's is the same at every height.
TEST(ShadowMap, TheFilterIsNoPenumbra) {
    const auto rows = measure_penumbras();
    const auto number = [](const Row &row, const char *name) { return std::get<double>(*row.find(name)); };
    EXPECT_GT(number(rows.back(), "lamp"), 20 * number(rows.front(), "lamp"));
    for (const char *filter : {"filter_0", "filter_4", "filter_12"})
        EXPECT_NEAR(number(rows.back(), filter), number(rows.front(), filter), 3e-3);
}

// C13: half the texel's width, half the error.
TEST(ShadowMap, TheErrorFallsWithTheResolution) {
    const SundialScene scene = sundial_scene();
    const auto cases = sundial_cases(scene, 160, 90);
    const auto wrong = [&](int resolution) {
        const MapErrors errors = errors_of(ShadowMap(scene, LightView(lamp_view), resolution), {}, cases);
        return errors.false_light + errors.false_shadow;
    };
    const double coarse = wrong(64), fine = wrong(512);
    EXPECT_GT(coarse, 4 * fine);
    EXPECT_LT(coarse, 16 * fine);
    EXPECT_GT(fine, 0);
}

// C13: floats alone are a matter of two units in the last place, and only where a point is itself stored in float.
TEST(ShadowMap, TheRoundingOfDepthsIsTwoUlps) {
    const SundialScene scene = sundial_scene();
    const LightView view(lamp_view);
    const ShadowMap map(scene, view, 64);
    const auto exact = texel_cases<double>(scene, view, 64), rounded = texel_cases<float>(scene, view, 64);
    EXPECT_EQ(errors_of(map, {.slope = 0, .ulps = 0}, exact).false_shadow, 0);
    EXPECT_GT(errors_of(map, {.slope = 0, .ulps = 0}, rounded).false_shadow, 1000);
    EXPECT_EQ(errors_of(map, {.slope = 0, .ulps = 2}, rounded).false_shadow, 0);
}

} // namespace
