// Lights against closed forms, shadows, and the erratum of A eq. 61.
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "chapters/03_light_and_shadow/measure.hpp"
#include "chapters/03_light_and_shadow/object.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

const Sphere<> unit_sphere{{0, 0, 0}, 1};
const Scene<Sphere<>> nothing{std::vector<Sphere<>>{}};

// The surface at the top of the unit sphere.
Surface<double, Sphere<>> top() { return surface(Ray<double>{{0, 3, 0}, {0, -1, 0}}, 2.0, unit_sphere); }

Lights<PointLight> one_light(const Vec<double> &position, const Colour &intensity = Colour(1)) {
    return Lights(std::vector{PointLight{position, intensity}});
}

template <class AnyScene, class AnyLights>
Colour light_on_top(const Colour &diffuse, const AnyScene &scene, const AnyLights &lights) {
    Random random(1);
    return direct_light(top(), {0, 1, 0}, diffuse, scene, lights, random);
}

TEST(PointLight, FallsWithTheSquareOfTheDistance) {
    for (const double distance : {0.5, 1.0, 3.0, 10.0}) {
        const Colour got = light_on_top(Colour(1), nothing, one_light({0, 1 + distance, 0}));
        EXPECT_FLOAT_EQ(got.r, static_cast<float>(1 / (distance * distance)));
    }
}

TEST(PointLight, FallsWithTheCosine) {
    for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
        const double angle = degrees * pi / 180;
        const Colour got =
            light_on_top(Colour(1), nothing, one_light({2 * std::sin(angle), 1 + 2 * std::cos(angle), 0}));
        EXPECT_NEAR(got.r, std::cos(angle) / 4, 1e-7);
    }
}

TEST(PointLight, SeveralLightsAdd) {
    const Lights lights(std::vector{PointLight{{0, 2, 0}, {1, 0, 0}}, PointLight{{0, 3, 0}, {0, 4, 0}}});
    EXPECT_EQ(light_on_top(Colour(1), nothing, lights), Colour(1, 1, 0));
}

// A eq. 61 as printed: c = c_l (r . n) / |r|³.
Colour printed_equation_61(const PointLight &light, const Vec<double> &point, const Vec<double> &normal) {
    const Vec<double> r = light.position - point;
    return static_cast<float>(dot(r, normal) / std::pow(length(r), 3)) * light.intensity;
}

// A surface cannot scatter a colour that it absorbs, and a light behind it cannot take light away.
TEST(PointLight, Equation61NeedsTheCoefficientAndTheMax) {
    const Colour red(1, 0, 0);
    const PointLight above{{0, 3, 0}, Colour(4)}, below{{0, -3, 0}, Colour(4)};
    EXPECT_EQ(printed_equation_61(above, {0, 1, 0}, {0, 1, 0}), Colour(1)); // white light from a red surface
    EXPECT_LT(printed_equation_61(below, {0, 1, 0}, {0, 1, 0}).r, 0);       // negative light
    EXPECT_EQ(light_on_top(red, nothing, one_light(above.position, above.intensity)), red);
    EXPECT_EQ(light_on_top(red, nothing, one_light(below.position, below.intensity)), Colour(0));
}

TEST(Shadow, OnlyWhatIsBetweenSurfaceAndLightCounts) {
    const auto blocked_by = [](const Vec<float> &centre) {
        return light_on_top(Colour(1), Scene(std::vector<Sphere<>>{unit_sphere, {centre, 0.5f}}), one_light({0, 5, 0}))
                   .r == 0;
    };
    EXPECT_TRUE(blocked_by({0, 3, 0}));
    EXPECT_FALSE(blocked_by({0, 6, 0})); // beyond the light: the light's distance is t_max
    EXPECT_FALSE(blocked_by({2, 3, 0})); // beside
}

TEST(Shadow, ObjectsBlockAsTheirShapesDo) {
    const Scene scene(std::vector{Object<Sphere<>, Diffuse<>>{{{0, 3, 0}, 0.5f}, {Colour(1)}}});
    EXPECT_EQ(light_on_top(Colour(1), scene, one_light({0, 5, 0})), Colour(0));
}

TEST(Shadow, ALampThatIsAnObjectDoesNotShadowItself) {
    const Sphere<> lamp{{0.3f, 7, -0.2f}, 0.25f};
    Random random(3);
    const auto surface_at_top = top();
    for (int i = 0; i < 10000; ++i) {
        const Vec<double> aside(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        const auto on_lamp = Vec<double>(lamp.centre) + 0.25 * normalize(Vec<double>(0, -2, 0) + aside);
        EXPECT_TRUE(lit_by(sample_towards(on_lamp, surface_at_top.point), surface_at_top,
                           Scene(std::vector{unit_sphere, lamp})));
    }
}

const Rectangle ceiling{{-0.5, 4, -0.5}, {1, 0, 0}, {0, 0, 1}}; // a x b points down

// From far away an area light is a point light of the intensity area x radiance / pi.
TEST(AreaLight, FromAfarItIsAPointLight) {
    const Rectangle far{{-0.5, 1001, -0.5}, {1, 0, 0}, {0, 0, 1}};
    const Lights lights(std::vector{AreaLight<Rectangle>{far, Colour(static_cast<float>(pi) * 1e6f)}});
    EXPECT_NEAR(light_on_top(Colour(1), nothing, lights).r, 1, 1e-6);
}

// Lambert's polygon formula: the light of a rectangle with radiance 1 on a surface that faces it, a x b at the height h
// straight above one corner, is 1/(2 pi) [a/sqrt(a²+h²) atan(b/sqrt(a²+h²)) + b/sqrt(b²+h²) atan(a/sqrt(b²+h²))].
TEST(AreaLight, AgreesWithLambertsPolygonFormula) {
    const double h = 3, a = 0.5;
    const double side = std::sqrt(a * a + h * h);
    const double exact = 4 * (1 / (2 * pi)) * 2 * (a / side) * std::atan(a / side);
    Lights lights(std::vector{AreaLight<Rectangle>{ceiling, Colour(1), 32}});
    EXPECT_NEAR(light_on_top(Colour(1), nothing, lights).r / exact, 1, 1e-4);
}

// A disk of radius r and radiance 1 at the height h, parallel to the surface: r² / (r² + h²).
TEST(AreaLight, ADiskAgreesWithItsClosedForm) {
    const Lights lights(std::vector{AreaLight<Disk<>>{{{0, 4, 0}, {0, -2, 0}, 1.5f}, Colour(1), 32}});
    EXPECT_NEAR(light_on_top(Colour(1), nothing, lights).r / (2.25 / (2.25 + 9)), 1, 1e-4);
}

// The share of the light's samples that reach a place of the floor y = 0.
double visible_share(const Vec<double> &place, const Scene<Box<>> &scene, const AreaLight<Rectangle> &light) {
    const Plane<> floor{{0, 0, 0}, {0, 1, 0}};
    const Surface<double, Plane<>> surface{place, {0, 1, 0}, floor};
    Random random(11);
    int lit = 0;
    for_each_sample(light, place, random, [&](const LightSample &sample) { lit += lit_by(sample, surface, scene); });
    return static_cast<double>(lit) / (light.strata * light.strata);
}

// Similar triangles: under an edge at the height h, a light of the width w at the height H casts a penumbra of the
// width w h / (H - h), and half-way through it half of the light is seen.
TEST(AreaLight, ThePenumbraIsAsWideAsSimilarTrianglesSay) {
    const double w = 0.8, height = 5;
    const AreaLight<Rectangle> light{{{-w / 2, height, -0.1}, {w, 0, 0}, {0, 0, 0.2}}, Colour(1), 20};
    for (const float edge_height : {0.5f, 1.0f, 2.0f, 4.0f}) {
        const Scene roof(std::vector{Box<>{{0, edge_height, -50}, {50, edge_height, 50}}}); // flat, its edge at x = 0
        const double penumbra = w * edge_height / (height - edge_height), bit = 1e-3 * penumbra;
        EXPECT_EQ(visible_share({-penumbra / 2 - bit, 0, 0}, roof, light), 1);
        EXPECT_NEAR(visible_share({-penumbra / 4, 0, 0}, roof, light), 0.75, 0.02);
        EXPECT_NEAR(visible_share({0, 0, 0}, roof, light), 0.5, 0.02);
        EXPECT_NEAR(visible_share({penumbra / 4, 0, 0}, roof, light), 0.25, 0.02);
        EXPECT_EQ(visible_share({penumbra / 2 + bit, 0, 0}, roof, light), 0);
        EXPECT_LT(visible_share({-penumbra / 2 + 0.06 * penumbra, 0, 0}, roof, light), 1);
        EXPECT_GT(visible_share({penumbra / 2 - 0.06 * penumbra, 0, 0}, roof, light), 0);
    }
}

TEST(AreaLight, TheSameSeedGivesTheSameSamples) {
    const auto sum = [](std::uint64_t seed) {
        Random random(seed);
        return direct_light(top(), {0, 1, 0}, Colour(1), nothing,
                            Lights(std::vector{AreaLight<Rectangle>{ceiling, Colour(1), 3}}), random);
    };
    EXPECT_EQ(sum(4), sum(4));
    EXPECT_NE(sum(4), sum(5));
}

TEST(AreaLight, ItsBackIsDark) {
    const Rectangle upwards{{-0.5, 4, -0.5}, {0, 0, 1}, {1, 0, 0}};
    EXPECT_EQ(light_on_top(Colour(1), nothing, Lights(std::vector{AreaLight<Rectangle>{upwards, Colour(1)}})),
              Colour(0));
}

// C12, as the chapter's experiment measures it.
TEST(Measurements, AConstantOffsetGoesWrongAtBothEnds) {
    EXPECT_GT(tally_spawns(1e-4, 1e-3, 1000, 1).leaks, 900);
    EXPECT_EQ(tally_spawns(1, 1e-3, 1000, 1).acne + tally_spawns(1, 1e-3, 1000, 1).leaks, 0);
    EXPECT_GT(tally_spawns(1e6, 1e-3, 1000, 1).acne, 300);
    for (const double size : {1e-4, 1.0, 1e6})
        EXPECT_EQ(tally_spawns(size, -1, 1000, 1).acne + tally_spawns(size, -1, 1000, 1).leaks, 0);
}

// Independent samples converge with the root of their number; strata in two dimensions with its 3/4th power where an
// edge crosses the light.
TEST(Measurements, StrataConvergeFaster) {
    Plot plot;
    const auto rows = measure_noise(plot, 1);
    const auto slope = [&](std::size_t series) {
        const auto &points = plot.series[series].points;
        return std::log(points.back().y / points.front().y) / std::log(points.back().x / points.front().x);
    };
    EXPECT_NEAR(slope(0), -0.5, 0.05);
    EXPECT_NEAR(slope(1), -0.75, 0.05);
}

} // namespace
