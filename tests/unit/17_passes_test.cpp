// What the passes of chapter 17 sample, without any OpenGL.
#include "chapters/03_light_and_shadow/sundial.hpp"
#include "chapters/17_gpu/passes.hpp"

#include <gtest/gtest.h>
#include <set>

using namespace course;

TEST(LampCells, EachComesOnceInARound) {
    for (const int strata : {1, 2, 3, 4, 8, 16}) {
        std::set<std::pair<int, int>> seen;
        for (int pass = 0; pass < strata * strata; ++pass) {
            const glm::ivec2 cell = lamp_cell(pass, strata);
            EXPECT_TRUE(cell.x >= 0 && cell.y >= 0 && cell.x < strata && cell.y < strata);
            EXPECT_TRUE(seen.emplace(cell.x, cell.y).second) << strata << " " << pass;
        }
        EXPECT_EQ(lamp_cell(strata * strata, strata), lamp_cell(0, strata));
    }
}

// A quarter of a round has been in every quarter of the lamp.
TEST(LampCells, AreSoonEverywhere) {
    int quarters[2][2] = {};
    for (int pass = 0; pass < 16; ++pass) {
        const glm::ivec2 cell = lamp_cell(pass, 8);
        ++quarters[cell.y / 4][cell.x / 4];
    }
    for (const auto &row : quarters)
        for (const int count : row)
            EXPECT_GE(count, 2);
}

// A round of passes brings what chapter 03's light brings at once.
template <class Form> void expect_same_light(const Form &form) {
    const auto pass = std::make_shared<int>(0);
    const AreaLight<Form> whole{form, {1, 1, 1}, 8};
    const PassLight<Form> cells{whole, pass};
    for (const Vec<double> &point : {Vec<double>(0, 0, 0), Vec<double>(2, 0.3, 1), Vec<double>(-9, 5, -4)}) {
        Random random(3);
        double at_once = 0, passes = 0;
        for (int round = 0; round < 64; ++round)
            for_each_sample(whole, point, random, [&](const LightSample &sample) { at_once += sample.radiance.r; });
        for (*pass = 0; *pass < 64 * 64; ++*pass)
            for_each_sample(cells, point, random, [&](const LightSample &sample) { passes += sample.radiance.r / 64; });
        EXPECT_GT(at_once, 0);
        EXPECT_NEAR(passes / at_once, 1, 0.01);
    }
}
TEST(PassLight, ARoundIsTheWholeDisk) { expect_same_light(lamp_disk); }
TEST(PassLight, ARoundIsTheWholeRectangle) { expect_same_light(Rectangle{{-11, 9, -6}, {0.5, 0.5, -2}, {1, 1, 0}}); }

TEST(SamplePlaces, TheFirstIsTheMiddle) { EXPECT_EQ(sample_place(0), glm::dvec2(0.5)); }
