// The difference of two pictures against values worked out by hand.
#include "common/errors.hpp"
#include "common/image_difference.hpp"
#include "common/image_files.hpp"

#include <gtest/gtest.h>
#include <limits>

using namespace course;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

TEST(ImageDifference, APictureIsNotApartFromItself) {
    const Picture picture(3, 2, Colour(0.2f, nan, infinity));
    const auto apart = difference(picture, picture, 0);
    EXPECT_EQ(apart.rmse, 0);
    EXPECT_EQ(apart.largest_steps, 0);
    EXPECT_EQ(apart.differing_per_million, 0);
}

// One channel of one of four pixels is one half off: the mean square is (1/2)² / 12.
TEST(ImageDifference, OneChannelOfOnePixel) {
    const Picture black(2, 2);
    Picture other = black;
    other(1, 0).g = 0.5f;
    const auto apart = difference(black, other);
    EXPECT_DOUBLE_EQ(apart.rmse, std::sqrt(0.25 / 12));
    EXPECT_EQ(apart.largest, 0.5);
    EXPECT_EQ(apart.differing_per_million, 250000);
    const double steps = 255 * static_cast<double>(srgb_from_linear(0.5f));
    EXPECT_NEAR(steps, 187.5, 0.1); // sRGB's middle grey
    EXPECT_DOUBLE_EQ(apart.largest_steps, steps);
    EXPECT_DOUBLE_EQ(apart.rmse_steps, steps / std::sqrt(12.0));
}

TEST(ImageDifference, OneStepOfEightBitsIsAllowedAndTwoAreNot) {
    const auto grey = [](float step) { return Picture(1, 1, Colour(linear_from_srgb(step / 255))); };
    EXPECT_EQ(difference(grey(100), grey(100.9f)).differing_per_million, 0);
    EXPECT_EQ(difference(grey(100), grey(101.1f)).differing_per_million, 1e6);
}

TEST(ImageDifference, OutsideOfZeroToOneOnlyTheLinearValuesDiffer) {
    const auto apart = difference(Picture(1, 1, Colour(2)), Picture(1, 1, Colour(5)));
    EXPECT_EQ(apart.rmse, 3);
    EXPECT_EQ(apart.rmse_steps, 0);
}

TEST(ImageDifference, NotANumberOnOneSideIsInfinitelyFar) {
    const auto apart = difference(Picture(1, 1), Picture(1, 1, Colour(0, nan, 0)));
    EXPECT_EQ(apart.rmse, infinity);
    EXPECT_EQ(apart.rmse_steps, infinity);
    EXPECT_EQ(apart.differing_per_million, 1e6);
    const Picture shown = difference_picture(Picture(1, 1), Picture(1, 1, Colour(0, nan, 0)));
    EXPECT_EQ(shown(0, 0).g, 1);
    EXPECT_EQ(shown(0, 0).r, 0);
}

TEST(ImageDifference, DifferentSizesAreRefused) {
    EXPECT_THROW(difference(Picture(2, 3), Picture(3, 2)), InputError);
    EXPECT_THROW(difference_picture(Picture(2, 3), Picture(3, 2)), InputError);
}

} // namespace
