// The viewer's hand on the camera, without a window: where the eye and the target go, and what stays as it was.
#include "common/navigator.hpp"

#include <gtest/gtest.h>
#include <limits>

using namespace course;

namespace {

const Viewpoint home{.eye = {0, 0, 5}, .target = {0, 0, 0}, .up = {0, 1, 0}, .field_of_view = 40};

void expect_near(const Vec<double> &value, const Vec<double> &expected) {
    EXPECT_LT(length(value - expected), 1e-12) << value.x << ' ' << value.y << ' ' << value.z;
}

double angle_from_up(const Viewpoint &view) {
    return std::acos(dot(normalize(view.eye - view.target), normalize(view.up)));
}

TEST(Navigator, StartsAtHome) { EXPECT_EQ(Navigator(home).viewpoint(), home); }

TEST(Navigator, HalfAWindowToTheRightIsAQuarterTurn) {
    Navigator navigator(home);
    navigator.orbit(0.5, 0);
    expect_near(navigator.viewpoint().eye, {-5, 0, 0}); // the scene turned to the right, so the eye went left
    expect_near(navigator.viewpoint().target, {0, 0, 0});
}

TEST(Navigator, DraggingDownRaisesTheEye) {
    Navigator navigator(home);
    navigator.orbit(0, 0.25);
    expect_near(navigator.viewpoint().eye, {0, 5 * std::sqrt(0.5), 5 * std::sqrt(0.5)});
}

TEST(Navigator, AnOrbitKeepsTheDistance) {
    Navigator navigator({.eye = {3, -2, 7}, .target = {1, 1, 1}, .up = {0.2, 2, 0.1}});
    const double distance = length(Vec<double>(2, -3, 6));
    for (int i = 0; i < 1000; ++i) {
        navigator.orbit(0.013 * (i % 7), 0.021 * (i % 5 - 2));
        ASSERT_NEAR(length(navigator.viewpoint().eye - navigator.viewpoint().target), distance, 1e-9);
    }
}

TEST(Navigator, AnOrbitThereAndBackEndsWhereItBegan) {
    Navigator navigator(home);
    navigator.orbit(0.2, 0.1);
    navigator.orbit(-0.2, -0.1);
    expect_near(navigator.viewpoint().eye, home.eye);
}

// Past the pole the picture would turn over; it stops short instead, and can be turned back.
TEST(Navigator, StopsBeforeThePoles) {
    Navigator navigator(home);
    navigator.orbit(0, 40);
    EXPECT_NEAR(angle_from_up(navigator.viewpoint()), 0.02, 1e-9);
    navigator.orbit(0, -40);
    EXPECT_NEAR(angle_from_up(navigator.viewpoint()), pi - 0.02, 1e-9);
}

TEST(Navigator, LookingAroundKeepsTheEye) {
    Navigator navigator(home);
    navigator.look(1, 0); // one height of the window is one field of view
    const double angle = 40 * pi / 180;
    expect_near(navigator.viewpoint().eye, home.eye);
    expect_near(navigator.viewpoint().target, {-5 * std::sin(angle), 0, 5 - 5 * std::cos(angle)});
    navigator.look(-1, 0.5);
    expect_near(navigator.viewpoint().target, {0, 5 * std::sin(angle / 2), 5 - 5 * std::cos(angle / 2)});
}

TEST(Navigator, ANotchIsATenthNearer) {
    Navigator navigator(home);
    navigator.zoom(1);
    expect_near(navigator.viewpoint().eye, {0, 0, 4.5});
    navigator.zoom(-1);
    expect_near(navigator.viewpoint().eye, {0, 0, 5});
}

TEST(Navigator, ZoomNeverReachesTheTargetNorInfinity) {
    Navigator navigator(home);
    navigator.zoom(1e6);
    EXPECT_NEAR(navigator.viewpoint().eye.z, 5e-4, 1e-12);
    navigator.zoom(-1e6);
    EXPECT_NEAR(navigator.viewpoint().eye.z, 5e4, 1e-6);
}

TEST(Navigator, FliesWhileAKeyIsHeld) {
    Navigator navigator(home);
    navigator.elapse(1);
    EXPECT_EQ(navigator.viewpoint(), home);
    navigator.press(Motion::forward);
    EXPECT_TRUE(navigator.flying());
    const double after_the_tap = navigator.viewpoint().eye.z;
    EXPECT_LT(after_the_tap, 5);
    navigator.elapse(1);
    navigator.release(Motion::forward);
    navigator.elapse(1);
    EXPECT_FALSE(navigator.flying());
    EXPECT_NEAR(navigator.viewpoint().eye.z, after_the_tap - 2.5, 1e-12); // half the first distance in a second
    expect_near(navigator.viewpoint().eye - navigator.viewpoint().target, {0, 0, 5});
}

TEST(Navigator, EachMotionGoesItsWay) {
    const std::array<Vec<double>, 6> ways{{{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        Navigator navigator(home);
        navigator.press(static_cast<Motion>(i));
        expect_near(normalize(navigator.viewpoint().eye - home.eye), ways[i]);
    }
}

TEST(Navigator, OppositeKeysCancel) {
    Navigator navigator(home);
    navigator.press(Motion::left);
    navigator.press(Motion::right);
    navigator.elapse(0.3);
    expect_near(navigator.viewpoint().eye, home.eye);
}

TEST(Navigator, ResetGoesHome) {
    Navigator navigator(home);
    navigator.orbit(0.3, 0.2);
    navigator.zoom(3);
    navigator.press(Motion::left);
    navigator.reset();
    EXPECT_EQ(navigator.viewpoint(), home);
}

// Straight down, at one's own eye, with no up at all: whatever is done, every number stays a number.
TEST(Navigator, OddViewpointsStayFinite) {
    for (const Viewpoint &odd :
         {Viewpoint{.eye = {0, 5, 0}, .target = {0, 0, 0}}, Viewpoint{.eye = {1, 1, 1}, .target = {1, 1, 1}},
          Viewpoint{.up = {0, 0, 0}}, Viewpoint{.eye = {4, 0, 0}, .up = {-1, 0, 0}}}) {
        Navigator navigator(odd);
        for (int i = 0; i < 6; ++i) {
            navigator.press(static_cast<Motion>(i));
            navigator.elapse(0.1 * i);
        }
        navigator.orbit(0.1, 0.1);
        navigator.look(-0.2, 0.3);
        navigator.zoom(2);
        const Viewpoint &view = navigator.viewpoint();
        EXPECT_TRUE(std::isfinite(dot(view.eye, view.eye) + dot(view.target, view.target)));
    }
}

} // namespace
