// The oracle against cases whose answer is known by hand, against its own intervals, and against kernels broken on
// purpose.
#include "chapters/01_ray_casting/sphere.hpp"
#include "common/random.hpp"
#include "tests/oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace course;
using exact::Answer;
using exact::Verdict;

namespace {

void expect_hit(const Answer &answer, double t) {
    EXPECT_EQ(answer.verdict, Verdict::hit);
    EXPECT_DOUBLE_EQ(answer.t, t);
}
void expect_miss(const Answer &answer) {
    EXPECT_EQ(answer.verdict, Verdict::miss);
    EXPECT_EQ(answer.t, infinity<double>);
}

const double tiny = 0x1p-60; // far below what a double sees beside 1

TEST(OracleSphere, NearFarAndNone) {
    expect_hit(exact::sphere({{0, 0, 5}, {0, 0, -1}}, {0, 0, 0}, 1), 4);
    expect_hit(exact::sphere({{0, 0, 5}, {0, 0, -2}}, {0, 0, 0}, 1), 2);
    expect_hit(exact::sphere({{0, 0, 0.5}, {0, 0, -1}}, {0, 0, 0}, 1), 1.5);
    expect_miss(exact::sphere({{0, 0, 5}, {0, 0, 1}}, {0, 0, 0}, 1));
    expect_miss(exact::sphere({{0, 0, 5}, {0, 0, 0}}, {0, 0, 0}, 1));
}

TEST(OracleSphere, ATangentTouchesAndBeyondItMisses) {
    expect_hit(exact::sphere({{1, 0, 5}, {0, 0, -1}}, {0, 0, 0}, 1), 5);
    expect_miss(exact::sphere({{1, 0, 5}, {tiny, 0, -1}}, {0, 0, 0}, 1)); // leans outwards by less than a double sees
    EXPECT_TRUE(exact::sphere({{1, 0, 5}, {-tiny, 0, -1}}, {0, 0, 0}, 1).may_hit());
}

TEST(OracleSphere, FromTheSurfaceItselfOnlyTheOtherRootCounts) {
    expect_miss(exact::sphere({{0, 0, 1}, {0, 0, 1}}, {0, 0, 0}, 1));
    expect_hit(exact::sphere({{0, 0, 1}, {0, 0, -1}}, {0, 0, 0}, 1), 2);
    expect_hit(exact::sphere({{0, 0, 1}, {0, 1, -1}}, {0, 0, 0}, 1), 1);
}

TEST(OracleSphere, TheRangeIsOpenAndComparedExactly) {
    const Vec<double> eye(0, 0, 5), ahead(0, 0, -1), centre(0, 0, 0);
    expect_hit(exact::sphere({eye, ahead, 4}, centre, 1), 6);
    expect_hit(exact::sphere({eye, ahead, std::nextafter(4.0, 0.0)}, centre, 1), 4);
    expect_miss(exact::sphere({eye, ahead, 0, 4}, centre, 1));
    expect_hit(exact::sphere({eye, ahead, 0, std::nextafter(4.0, 5.0)}, centre, 1), 4);
    expect_miss(exact::sphere({eye, ahead, 4, 6}, centre, 1));
}

TEST(OraclePlane, EitherSideParallelAndWithin) {
    expect_hit(exact::plane({{0, 2, 0}, {1, -1, 0}}, {7, 0, 7}, {0, 3, 0}), 2);
    expect_hit(exact::plane({{0, -2, 0}, {1, 1, 0}}, {7, 0, 7}, {0, 3, 0}), 2);
    expect_miss(exact::plane({{0, 2, 0}, {1, 1, 0}}, {7, 0, 7}, {0, 3, 0}));
    expect_miss(exact::plane({{0, 2, 0}, {1, 0, 0}}, {7, 0, 7}, {0, 3, 0}));
    expect_miss(exact::plane({{0, 0, 0}, {1, 0, 0}}, {7, 0, 7}, {0, 3, 0}));
    expect_miss(exact::plane({{0, 0, 0}, {1, -1, 0}}, {7, 0, 7}, {0, 3, 0})); // t = 0 is not in range
    EXPECT_TRUE(exact::plane({{0, 2, 0}, {1, -tiny, 0}}, {7, 0, 7}, {0, 3, 0}).may_hit());
}

TEST(OracleDisk, TheRimBelongsToIt) {
    expect_hit(exact::disk({{3, 4, 1}, {0, 0, -1}}, {0, 0, 0}, {0, 0, 2}, 5), 1);
    expect_miss(exact::disk({{3, 4, 1}, {tiny, 0, -1}}, {0, 0, 0}, {0, 0, 2}, 5));
    expect_miss(exact::disk({{3, 4, 1}, {0, 0, 1}}, {0, 0, 0}, {0, 0, 2}, 5));
    expect_hit(exact::disk({{3, 4, 1}, {-3, -4, -1}}, {0, 0, 0}, {0, 0, 2}, 5), 1);
}

TEST(OracleTriangle, InsideOutsideAndOnTheRim) {
    const Vec<double> a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
    const auto down = [&](double x, double y) { return exact::triangle({{x, y, 2}, {0, 0, -1}}, a, b, c); };
    expect_hit(down(1, 1), 2);
    expect_miss(down(3, 3));
    expect_miss(down(-1, 1));
    expect_miss(down(1, -1e-300));
    expect_hit(down(1, 1e-300), 2);
    for (const Vec<double> rim : {Vec<double>(2, 0, 0), {0, 3, 0}, {2, 2, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}) {
        const auto answer = down(rim.x, rim.y);
        EXPECT_EQ(answer.verdict, Verdict::boundary);
        EXPECT_EQ(answer.t, 2);
    }
    expect_miss(exact::triangle({{-1, 1, 0}, {1, 0, 0}}, a, b, c));         // within the plane
    expect_miss(exact::triangle({{1, 1, 2}, {0, 0, -1}}, a, b, {2, 0, 0})); // no area
    expect_hit(exact::triangle({{1, 1, -2}, {0, 0, 1}}, a, b, c), 2);       // from behind
}

TEST(OracleAffineTriangle, EdgesAreWhereItsVectorsSay) {
    const auto down = [](double x, double y) { // corners (0, 0), (4, 0), (0, 2)
        return exact::affine_triangle({{x, y, 2}, {0, 0, -1}}, {0, 0, 0}, {0, 0, 3}, {0.25, 0, 0}, {0, 0.5, 0});
    };
    expect_hit(down(1, 1), 2);
    expect_hit(down(2, 1), 2); // edges belong to it
    expect_hit(down(0, 0), 2);
    expect_miss(down(2, std::nextafter(1.0, 2.0)));
    expect_miss(down(-1e-300, 1));
    expect_miss(down(1, -1e-300));
}

TEST(OracleBox, EnterLeaveFlatAndAlongAFace) {
    const Vec<double> lo(-1, -1, -1), hi(1, 1, 1);
    expect_hit(exact::box({{0, 0, 3}, {0, 0, -1}}, lo, hi), 2);
    expect_hit(exact::box({{0, 0, 0}, {0, 0, -1}}, lo, hi), 1);
    expect_hit(exact::box({{1, 0, 3}, {0, 0, -1}}, lo, hi), 2); // within a face
    expect_miss(exact::box({{1, 0, 3}, {tiny, 0, -1}}, lo, hi));
    expect_hit(exact::box({{3, 3, 0}, {-1, -1, 0}}, lo, hi), 2); // through an edge
    expect_hit(exact::box({{2, 0, 0}, {-1, 1, 0}}, lo, hi), 1);  // touches an edge
    expect_miss(exact::box({{0, 0, 3}, {0, 0, 1}}, lo, hi));
    expect_miss(exact::box({{0, 0, 3}, {0, 0, 0}}, lo, hi));
    expect_hit(exact::box({{0, 0, 3}, {0, 0, -1}}, {-1, -1, 0}, {1, 1, 0}), 3);
}

TEST(OracleCylinder, WallOnlyAndNoCaps) {
    const Vec<double> bottom(0, 0, 0), top(0, 0, 2);
    expect_hit(exact::cylinder({{5, 0, 1}, {-1, 0, 0}}, bottom, top, 1), 4);
    expect_hit(exact::cylinder({{0, 0, 1}, {-1, 0, 0}}, bottom, top, 1), 1);
    expect_hit(exact::cylinder({{5, 0, 2}, {-1, 0, 0}}, bottom, top, 1), 4); // the rim belongs to it
    expect_hit(exact::cylinder({{5, 0, 0}, {-1, 0, 0}}, bottom, top, 1), 4);
    expect_miss(exact::cylinder({{5, 0, 2}, {-1, 0, tiny}}, bottom, top, 1));
    expect_hit(exact::cylinder({{0, 0, 3}, {0.5, 0, -1}}, bottom, top, 1), 2); // through the open top, from within
    expect_miss(exact::cylinder({{0.5, 0, 5}, {0, 0, -1}}, bottom, top, 1));   // along the axis, through both ends
    expect_miss(exact::cylinder({{1, 0, 5}, {0, 0, -1}}, bottom, top, 1));     // along the wall
    expect_hit(exact::cylinder({{5, 1, 1}, {-1, 0, 0}}, bottom, top, 1), 5);   // a tangent
    expect_miss(exact::cylinder({{5, 1, 1}, {-1, tiny, 0}}, bottom, top, 1));
}

TEST(OracleCone, WallApexAndTheMirroredNappe) {
    const Vec<double> apex(0, 0, 2), base(0, 0, 0); // radius 2 below: a right angle at the apex
    expect_hit(exact::cone({{5, 0, 1}, {-1, 0, 0}}, apex, base, 2), 4);
    expect_hit(exact::cone({{0, 0, 1}, {-1, 0, 0}}, apex, base, 2), 1);
    expect_miss(exact::cone({{5, 0, 3}, {-1, 0, 0}}, apex, base, 2));   // only the mirrored nappe
    expect_hit(exact::cone({{5, 0, 2}, {-1, 0, 0}}, apex, base, 2), 5); // touches the apex
    expect_miss(exact::cone({{5, 0, 2}, {-1, 0, tiny}}, apex, base, 2));
    expect_hit(exact::cone({{5, 0, 0}, {-1, 0, 0}}, apex, base, 2), 3);    // the base circle
    expect_hit(exact::cone({{2, 0, 1}, {-1, 0, -1}}, apex, base, 2), 0.5); // parallel to a generator
    expect_miss(exact::cone({{3, 0, -1}, {-1, 0, 1}}, apex, base, 2));     // along a generator
    expect_hit(exact::cone({{0, 0, 5}, {0, 0, -1}}, apex, base, 2), 3);    // down the axis, at the apex
    expect_hit(exact::cone({{0.5, 0, 5}, {0, 0, -1}}, apex, base, 2), 3.5);
}

// Of hard rays the intervals decide most, and rationals the rest. (oracle_second_opinion_test.cpp asks rationals about
// all of them.) Numbers that are four times as large change no verdict, and t alone in its scale.
TEST(Oracle, FiltersMostAndFallsBackForTheRest) {
    const auto before = exact::tally();
    Random random(7);
    for (int i = 0; i < 20000; ++i) {
        const Vec<double> eye(random.uniform(-9, 9), random.uniform(-9, 9), 10);
        const double lean = i % 4 == 0 ? 0x1p-70 * random.uniform(-1, 1) : random.uniform(-0.1, 0.1);
        const Answer one = exact::sphere({{eye.x + 1, eye.y, 10}, {lean, 0, -1}}, {eye.x, eye.y, 0}, 1);
        const Answer scaled =
            exact::sphere({{4 * (eye.x + 1), 4 * eye.y, 40}, {lean, 0, -1}}, {4 * eye.x, 4 * eye.y, 0}, 4);
        EXPECT_EQ(one.verdict, scaled.verdict);
        if (one.may_hit()) {
            EXPECT_NEAR(scaled.t / one.t, 4, 1e-12);
        }
    }
    const auto after = exact::tally();
    EXPECT_GT(after.exact - before.exact, 2000u);
    EXPECT_LT(after.exact - before.exact, 20000u);
}

// A sphere test with the classic slip, c = |m|² - r instead of r²; and one that is right but computed in float.
std::optional<float> broken(const Ray<float> &ray, const Sphere<> &sphere) {
    return intersect_textbook(ray, Sphere<>{sphere.centre, std::sqrt(sphere.radius)});
}

TEST(Oracle, CatchesABrokenKernelAndAnImpreciseOne) {
    int slip_caught = 0, float_caught = 0;
    Random random(3);
    const auto slant = [&] { return static_cast<float>(random.uniform(-1.2e-4, 1.2e-4)); };
    for (int i = 0; i < 2000; ++i) {
        const Sphere<> sphere{{0, 0, -10000}, 1.05f};
        const Ray<float> ray{{0, 0, 0}, {slant(), slant(), -1}};
        const Ray<double> line{Vec<double>(ray.origin), Vec<double>(ray.direction)};
        const Answer truth = exact::sphere(line, Vec<double>(sphere.centre), static_cast<double>(sphere.radius));
        slip_caught += broken(ray, sphere).has_value() != truth.may_hit();
        float_caught += intersect_textbook(ray, sphere).has_value() != truth.may_hit();
    }
    EXPECT_GT(slip_caught, 20);
    EXPECT_GT(float_caught, 100);
}

} // namespace
