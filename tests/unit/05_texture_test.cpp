// Texture coordinates of every shape, pictures looked up by them, skies, and the sampling of pixels.
#include "chapters/05_texture/antialias.hpp"
#include "chapters/05_texture/textured_scene.hpp"
#include "common/image_difference.hpp"
#include "tests/unit/widened.hpp"

#include <filesystem>
#include <gtest/gtest.h>

using namespace course;

namespace {

constexpr double ulp = 0x1p-52;

Vec<double> random_direction(Random &random) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

void expect_uv(const Uv &found, double u, double v) {
    EXPECT_NEAR(found.x, u, 4 * ulp);
    EXPECT_NEAR(found.y, v, 4 * ulp);
}

TEST(Frame, IsRightHandedAndUpright) {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec<double> axis = random_direction(random) * std::exp(random.uniform(-20, 20));
        const Frame f = frame_around(axis);
        EXPECT_NEAR(dot(f.e0, f.e0), 1, 8 * ulp);
        EXPECT_NEAR(dot(f.e1, f.e1), 1, 8 * ulp);
        EXPECT_NEAR(dot(f.e0, f.e1), 0, 8 * ulp);
        EXPECT_NEAR(length(cross(f.e0, f.e1) - normalize(axis)), 0, 16 * ulp);
        EXPECT_EQ(f.e0.y, 0);
        EXPECT_GE(f.e1.y, 0);
    }
    EXPECT_EQ(frame_around({0, 3, 0}).e0, Vec<double>(1, 0, 0));
    EXPECT_EQ(frame_around({0, -3, 0}).e0, Vec<double>(1, 0, 0));
}

TEST(SphereUv, KnownPlacesAndExactPoles) {
    const Sphere<> sphere{{3, -2, 5}, 2};
    const Vec<double> c(sphere.centre);
    EXPECT_EQ(uv(sphere, c + Vec<double>(0, 2, 0)).y, 1);
    EXPECT_EQ(uv(sphere, c - Vec<double>(0, 2, 0)).y, 0);
    EXPECT_TRUE(std::isfinite(uv(sphere, c + Vec<double>(0, 2, 0)).x));
    expect_uv(uv(sphere, c + Vec<double>(2, 0, 0)), 0, 0.5);
    expect_uv(uv(sphere, c + Vec<double>(0, 0, -2)), 0.25, 0.5);
    expect_uv(uv(sphere, c + Vec<double>(-2, 0, 0)), 0.5, 0.5);
    expect_uv(uv(sphere, c + Vec<double>(0, 0, 2)), 0.75, 0.5);
    expect_uv(uv(sphere, c + Vec<double>(std::sqrt(2), std::sqrt(2), 0)), 0, 0.75);
}

// Two places a small step apart have coordinates a small step apart, if u is taken as an angle; u itself jumps only
// across the seam, the half circle through +x.
TEST(SphereUv, IsContinuousButAtTheSeam) {
    Random random(2);
    int jumps = 0;
    for (int i = 0; i < 200000; ++i) {
        const Vec<double> p = random_direction(random), q = normalize(p + 1e-7 * random_direction(random));
        const Uv a = spherical_uv(p), b = spherical_uv(q);
        ASSERT_TRUE(a.x >= 0 && a.x < 1 && a.y >= 0 && a.y <= 1);
        ASSERT_LT(std::abs(a.y - b.y), 1e-7);
        const double circle = std::sqrt(p.x * p.x + p.z * p.z), step = std::abs(a.x - b.x);
        ASSERT_LT(std::min(step, 1 - step) * circle, 1e-7);
        if (step > 0.5) {
            ++jumps;
            EXPECT_LT(std::abs(p.z), 1e-6);
            EXPECT_GT(p.x, -1e-6);
        }
    }
    EXPECT_LT(jumps, 20);
    for (const double z : {1e-9, 1e-17, 1e-300}) { // u starts at 0 and comes back to 1, not to 1 exactly
        EXPECT_LT(spherical_uv({1, 0, -z}).x, 1e-8);
        const double last = spherical_uv({1, 0, z}).x;
        EXPECT_TRUE(last < 1 && (last > 1 - 1e-8 || last == 0));
    }
}

TEST(DiskUv, IsTheSquareAroundIt) {
    const Disk<> disk{{1, 2, 3}, {0, 0, 5}, 2};
    expect_uv(uv(disk, Vec<double>(1, 2, 3)), 0.5, 0.5);
    expect_uv(uv(disk, Vec<double>(3, 2, 3)), 1, 0.5);
    expect_uv(uv(disk, Vec<double>(1, 4, 3)), 0.5, 1);
}

TEST(CylinderUv, TurnsAndRises) {
    const Cylinder<> cylinder{{1, 1, 1}, {1, 5, 1}, 2};
    expect_uv(uv(cylinder, Vec<double>(3, 1, 1)), 0, 0);
    expect_uv(uv(cylinder, Vec<double>(1, 2, -1)), 0.25, 0.25);
    expect_uv(uv(cylinder, Vec<double>(-1, 5, 1)), 0.5, 1);
    expect_uv(uv(cylinder, Vec<double>(1, 3, 3)), 0.75, 0.5);
}

TEST(ConeUv, ApexIsOneExactly) {
    const Cone<> cone{{0.3f, 2.7f, -1.1f}, {0.1f, -0.4f, 0.2f}, 1};
    EXPECT_EQ(uv(cone, Vec<double>(cone.apex)).y, 1);
    EXPECT_EQ(uv(cone, Vec<double>(cone.base)).y, 0);
    const Cone<> upright{{0, 2, 0}, {0, 0, 0}, 1};
    expect_uv(uv(upright, Vec<double>(0, 1, -0.5)), 0.25, 0.5);
}

TEST(TriangleUv, PlacedGivesTheCornersTheirPlaces) {
    const auto triangle = affine_triangle<double>({1, 0, 0}, {4, 1, 0}, {2, 3, -2});
    const Uv t0{0.2, 0.3}, t1{0.9, 0.4}, t2{0.5, 0.8};
    const Placed<Checker> placed{{}, t0, t1 - t0, t2 - t0};
    const auto at = [&](const Vec<double> &p) {
        const Uv affine = uv(triangle, p);
        return placed.origin + affine.x * placed.across + affine.y * placed.up;
    };
    const auto [a, b, c] = corners(triangle);
    for (const auto &[corner, place] : {std::pair{a, t0}, {b, t1}, {c, t2}, {(a + b + c) / 3.0, (t0 + t1 + t2) / 3.0}})
        EXPECT_NEAR(length(at(corner) - place), 0, 16 * ulp);
}

TEST(PlaneUv, CountsInLengthsOfTheScene) {
    const Plane<> floor{{1, 2, 3}, {0, 7, 0}};
    expect_uv(uv(floor, Vec<double>(5, 2, 3)), 4, 0);
    expect_uv(uv(floor, Vec<double>(1, 2, 1)), 0, 2);
}

// On every face, seen from outside: u to the right and v up (on top and bottom: x to the right).
TEST(BoxUv, EveryFaceIsAnUprightPicture) {
    const Box<> box{{-1, -2, -3}, {1, 2, 3}};
    expect_uv(uv(box, Vec<double>(1, -2 + 1, 3 - 1.5)), 0.25, 0.25);   // right face: to its right is -z
    expect_uv(uv(box, Vec<double>(-1, -2 + 1, -3 + 1.5)), 0.25, 0.25); // left: +z
    expect_uv(uv(box, Vec<double>(-0.5, -1, 3)), 0.25, 0.25);          // front: +x
    expect_uv(uv(box, Vec<double>(0.5, -1, -3)), 0.25, 0.25);          // back: -x
    expect_uv(uv(box, Vec<double>(-0.5, 2, 1.5)), 0.25, 0.25);         // top: up is -z
    expect_uv(uv(box, Vec<double>(-0.5, -2, -1.5)), 0.25, 0.25);       // bottom: up is +z
}

TEST(BoxUv, AFlatBoxHasFiniteCoordinates) {
    const Box<> sheet{{0, 0, 0}, {1, 0, 1}};
    const Uv found = uv(sheet, Vec<double>(0.25, 0, 0.5));
    EXPECT_TRUE(std::isfinite(found.x) && std::isfinite(found.y));
}

TEST(ImageTexture, IsExactAtTexelCentresAndLinearBetween) {
    const ImageTexture texture(paint(8, 4, [](const Uv &at) {
        return Colour(static_cast<float>(std::floor(8 * at.x)), static_cast<float>(std::floor(4 * at.y)), 0);
    }));
    EXPECT_EQ(colour_at(texture, {2.5 / 8, 1.5 / 4}), Colour(2, 1, 0));
    EXPECT_EQ(colour_at(texture, {3.0 / 8, 2.0 / 4}), Colour(2.5f, 1.5f, 0));
    EXPECT_EQ(nearest_texel(texture, {2.9 / 8, 1.1 / 4}), Colour(2, 1, 0));
    EXPECT_EQ(colour_at(texture, {5 + 2.5 / 8, 1.5 / 4}), Colour(2, 1, 0));  // repeats to the right
    EXPECT_EQ(colour_at(texture, {-7 + 2.5 / 8, 1.5 / 4}), Colour(2, 1, 0)); // and left
    EXPECT_EQ(colour_at(texture, {0, 0.5 / 4}).x, 3.5f);                     // the mean of the last and the first
    EXPECT_EQ(colour_at(texture, {2.5 / 8, 1}), Colour(2, 3, 0));            // holds at the top
    EXPECT_EQ(colour_at(texture, {2.5 / 8, 0}), Colour(2, 0, 0));            // and below
}

TEST(ImageTexture, RepeatsUpwardsWhereAsked) {
    const ImageTexture texture(
        paint(2, 4, [](const Uv &at) { return Colour(static_cast<float>(std::floor(4 * at.y))); }), Border::repeat);
    EXPECT_EQ(colour_at(texture, {0.25, 7 + 2.5 / 4}), Colour(2));
    EXPECT_EQ(colour_at(texture, {0.25, -3 + 2.5 / 4}), Colour(2));
    EXPECT_EQ(colour_at(texture, {0.25, 0}), Colour(1.5f)); // half the lowest, half the topmost
}

TEST(ImageTexture, StandsAnyCoordinates) {
    for (const Border border : {Border::around, Border::hold, Border::repeat}) {
        const ImageTexture texture(Picture(3, 3, Colour(0.5f)), border);
        for (const double odd : {1e300, -1e300, infinity<double>, -infinity<double>, std::nan(""), -1e-30, 1.0})
            for (const Uv &at : {Uv{odd, 0.3}, Uv{0.3, odd}}) {
                EXPECT_EQ(colour_at(texture, at), Colour(0.5f));
                EXPECT_EQ(nearest_texel(texture, at), Colour(0.5f));
            }
    }
}

TEST(ImageTexture, ComesBackFromAFile) {
    const auto file = std::filesystem::temp_directory_path() / "course_05_texture.png";
    const Picture painted = paint_bricks(64, 4, 4, 1);
    write_image(file, painted);
    const Picture read = read_image(file);
    std::filesystem::remove(file);
    EXPECT_LE(difference(painted, read).largest_steps, 0.51);
}

TEST(Checker, TakesTurns) {
    const Checker checker{Colour(1), Colour(0)};
    EXPECT_EQ(colour_at(checker, {0.5, 0.5}), Colour(1));
    EXPECT_EQ(colour_at(checker, {1.5, 0.5}), Colour(0));
    EXPECT_EQ(colour_at(checker, {-0.5, 0.5}), Colour(0));
    EXPECT_EQ(colour_at(checker, {-0.5, -0.5}), Colour(1));
    EXPECT_EQ(colour_at(checker, {1e300, 0.5}), Colour(1));
}

// The same function of coefficient and surface, whatever the coefficient's type.
TEST(Value, ATextureStandsInForAnyCoefficient) {
    const Plane<> floor{{0, 0, 0}, {0, 1, 0}};
    const Surface<double, Plane<>> surface{{0.5, 0, -1.5}, {0, 1, 0}, floor};
    const Checker checker{Colour(1), Colour(0)};
    EXPECT_EQ(value(Colour(0.25f), surface), Colour(0.25f));
    EXPECT_EQ(value(checker, surface), Colour(0));
    EXPECT_EQ(value(Placed<Checker>{checker, {1, 0}}, surface), Colour(1));
    EXPECT_EQ(value(1.5f, surface), 1.5f);
    EXPECT_EQ(value(Scaled<Checker>{checker, 1.25f, 2}, surface), 1.25f);
    static_assert(!Texture<Colour> && !Texture<float> && Texture<Placed<ImageTexture>>);
}

TEST(Sky, PlacesAndDirectionsAreEachOthersInverse) {
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const Vec<double> d = random_direction(random);
        EXPECT_LT(length(sky_direction(sky_uv(3.0 * d)) - d), 1e-14);
    }
    expect_uv(sky_uv({0, 0, -1}), 0.5, 0.5);
    expect_uv(sky_uv({1, 0, 0}), 0.75, 0.5); // the right of somebody who looks along -z
    EXPECT_EQ(sky_uv({0, 1, 0}).y, 1);
}

// A smooth sky, painted once as one picture and once as six, looks the same.
TEST(Sky, ABoxShowsTheSameAsOnePicture) {
    const auto sky = [](const Vec<double> &d) { return 0.5f + 0.5f * Colour(normalize(d)); };
    const ImageSky one{ImageTexture(paint(512, 256, [&](const Uv &at) { return sky(sky_direction(at)); }))};
    const auto face = [&](const Vec<double> &forward, const Vec<double> &right, const Vec<double> &up) {
        return ImageTexture(paint(256, 256,
                                  [&, forward, right, up](const Uv &at) {
                                      return sky(forward + (2 * at.x - 1) * right + (2 * at.y - 1) * up);
                                  }),
                            Border::hold);
    };
    const SkyBox box{{face({1, 0, 0}, {0, 0, 1}, {0, 1, 0}), face({-1, 0, 0}, {0, 0, -1}, {0, 1, 0}),
                      face({0, 1, 0}, {-1, 0, 0}, {0, 0, -1}), face({0, -1, 0}, {-1, 0, 0}, {0, 0, 1}),
                      face({0, 0, 1}, {-1, 0, 0}, {0, 1, 0}), face({0, 0, -1}, {1, 0, 0}, {0, 1, 0})}};
    Random random(4);
    for (int i = 0; i < 10000; ++i) {
        const Vec<double> d = random_direction(random);
        const Colour difference = sky_radiance(one, d) - sky_radiance(box, d);
        EXPECT_LT(length(difference), 0.03) << d.x << " " << d.y << " " << d.z;
    }
}

TEST(Sky, GradientAndConstant) {
    const GradientSky sky{Colour(1), Colour(0), Colour(0.5f)};
    EXPECT_EQ(sky_radiance(sky, {1, 0, 0}), Colour(1));
    EXPECT_EQ(sky_radiance(sky, {0, 2, 0}), Colour(0));
    EXPECT_EQ(sky_radiance(sky, {0, -1, 0}), Colour(0.5f));
    EXPECT_EQ(sky_radiance(ConstantSky{Colour(0.25f)}, {0, -1, 0}), Colour(0.25f));
}

Picture sampled(const Sampling &sampling, int width, int height, const auto &colour, const std::vector<Tile> &tiles) {
    Picture picture(width, height);
    const TileFunction fill = antialiased(sampling, colour);
    for (const Tile &tile : tiles)
        fill(tile, picture);
    return picture;
}

// A half plane at a slant: a pixel's value is the share of it that is covered.
TEST(Antialias, AnEdgeIsCoveredInProportion) {
    const auto edge = [](double x, double y, Random &) { return Colour(x + 0.3 * y < 10.37 ? 1.0f : 0.0f); };
    const Picture picture = sampled({2, 16}, 20, 20, edge, {{0, 0, 20, 20}});
    double sum = 0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x)
            sum += static_cast<double>(picture(x, y).r);
    EXPECT_NEAR(sum, 20 * (10.37 - 0.3 * 10), 0.15);
    EXPECT_EQ(picture(0, 0), Colour(1));
    EXPECT_EQ(picture(19, 19), Colour(0));
}

TEST(Antialias, SamplesMoreOnlyWhereColoursDiffer) {
    int calls = 0;
    const auto edge = [&](double x, double, Random &) { return ++calls, Colour(x < 10 ? 1.0f : 0.0f); };
    sampled({2, 8}, 20, 20, edge, {{0, 0, 20, 20}});
    EXPECT_EQ(calls, 20 * 20 * 4 + 2 * 20 * 64); // two columns of pixels on either side of the edge
    calls = 0;
    sampled({2, 2}, 20, 20, edge, {{0, 0, 20, 20}});
    EXPECT_EQ(calls, 20 * 20 * 4);
}

TEST(Antialias, TilesDoNotShow) {
    const auto waves = [](double x, double y, Random &random) {
        return Colour(static_cast<float>(std::sin(x * y) + 0.1 * random.uniform()));
    };
    const Picture whole = sampled({2, 5}, 24, 16, waves, {{0, 0, 24, 16}});
    const Picture cut = sampled({2, 5}, 24, 16, waves, {{0, 0, 7, 5}, {7, 0, 24, 5}, {0, 5, 13, 16}, {13, 5, 24, 16}});
    EXPECT_EQ(whole.pixels, cut.pixels);
}

} // namespace
