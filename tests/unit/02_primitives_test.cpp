// Every primitive of chapter 02 against closed forms on easy data, and the properties that each hit must have.
#include "chapters/02_primitives/random_shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>

using namespace course;

namespace {

using V = Vec<double>;
constexpr double inf = infinity<double>;

// Both forms of a test must say `expected`.
template <class Shape> void expect_hit(const Ray<double> &ray, const Shape &shape, double expected) {
    const auto t = intersect(ray, shape), textbook = intersect_textbook(ray, shape);
    ASSERT_TRUE(t);
    ASSERT_TRUE(textbook);
    EXPECT_DOUBLE_EQ(*t, expected);
    EXPECT_NEAR(*textbook, expected, 1e-12 * expected);
}

template <class Shape> void expect_miss(const Ray<double> &ray, const Shape &shape) {
    EXPECT_FALSE(intersect(ray, shape));
    EXPECT_FALSE(intersect_textbook(ray, shape));
}

template <class Shape> void expect_normal(const Ray<double> &ray, const Shape &shape, const V &normal) {
    const auto t = intersect(ray, shape);
    ASSERT_TRUE(t);
    EXPECT_LT(length(surface(ray, *t, shape).normal - normal), 1e-15);
}

// ---- Flat shapes
// -----------------------------------------------------------------------------------------------------

TEST(Plane, HeadOnFromBothSides) {
    const Plane<> plane{{0, 0, 1}, {0, 0, 2}};
    expect_hit({{3, 4, 5}, {0, 0, -1}}, plane, 4);
    expect_hit({{3, 4, -5}, {0, 0, 2}}, plane, 3);
    expect_normal({{3, 4, -5}, {0, 0, 2}}, plane, {0, 0, 1});
}

TEST(Plane, SlantedByTheClosedForm) {
    expect_hit({{0, 3, 0}, {4, -3, 0}}, Plane<>{{0, 0, 0}, {0, 1, 0}}, 1);
    expect_hit({{0, 0, 0}, {1, 2, 3}}, Plane<>{{1, 1, 1}, {1, 1, 1}}, 0.5);
}

TEST(Plane, ParallelWithinAndBehindAreMisses) {
    const Plane<> plane{{0, 0, 1}, {0, 0, 1}};
    expect_miss({{0, 0, 5}, {1, 0, 0}}, plane);
    expect_miss({{0, 0, 1}, {1, 0, 0}}, plane);
    expect_miss({{0, 0, 5}, {0, 0, 1}}, plane);
}

TEST(Disk, InsideAndOutsideTheRim) {
    const Disk<> disk{{1, 0, 0}, {0, 3, 0}, 2};
    expect_hit({{2.9, 5, 0}, {0, -1, 0}}, disk, 5);
    expect_miss({{3.1, 5, 0}, {0, -1, 0}}, disk);
    expect_normal({{2.9, -5, 0}, {0, 1, 0}}, disk, {0, 1, 0});
}

TEST(Disk, TheRimBelongsToIt) {
    const Disk<> disk{{0, 0, 0}, {0, 1, 0}, 5};
    EXPECT_EQ(intersect(Ray<double>{{3, 2, 4}, {0, -1, 0}}, disk), 2.0);
    EXPECT_FALSE(intersect_textbook(Ray<double>{{3, 2, 4}, {0, -1, 0}}, disk)) << "A eq. 33 leaves the rim out";
}

TEST(AffineTriangle, InsideOutsideAndWinding) {
    const auto triangle = affine_triangle<float>({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    expect_hit({{0.5, 0.5, 3}, {0, 0, -1}}, triangle, 3);
    expect_miss({{1.5, 1.5, 3}, {0, 0, -1}}, triangle);
    expect_miss({{-0.1, 0.5, 3}, {0, 0, -1}}, triangle);
    expect_miss({{0.5, -0.1, 3}, {0, 0, -1}}, triangle);
    expect_normal({{0.5, 0.5, -3}, {0, 0, 1}}, triangle, {0, 0, 1});
}

TEST(AffineTriangle, CornersAndEdgesBelongToIt) {
    const auto triangle = affine_triangle<float>({0, 0, 0}, {2, 0, 0}, {0, 2, 0});
    for (const V &p : {V(0, 0, 0), V(2, 0, 0), V(0, 2, 0), V(1, 0, 0), V(0, 1, 0), V(1, 1, 0)})
        expect_hit({p + V(0, 0, 3), {0, 0, -1}}, triangle, 3);
}

// A eq. 20 as printed: k1 = (|e2|² e1 - (e1 · e2) e2) / s, and so on.
TEST(AffineTriangle, K1AndK2AreEquation20) {
    const V a(1, 2, 3), b(4, -1, 2), c(0, 5, 7), e1 = b - a, e2 = c - a;
    const auto triangle = affine_triangle<double>(a, b, c);
    const double s = dot(cross(e1, e2), cross(e1, e2));
    EXPECT_LT(length(triangle.k1 - (dot(e2, e2) * e1 - dot(e1, e2) * e2) / s), 1e-15);
    EXPECT_LT(length(triangle.k2 - (dot(e1, e1) * e2 - dot(e1, e2) * e1) / s), 1e-15);
    EXPECT_NEAR(dot(triangle.k1, e1), 1, 1e-15);
    EXPECT_NEAR(dot(triangle.k1, e2), 0, 1e-15);
}

TEST(AffineTriangle, CornersComeBack) {
    const auto back = corners(affine_triangle<double>({1, 2, 3}, {4, -1, 2}, {0, 5, 7}));
    EXPECT_LT(length(back[0] - V(1, 2, 3)), 1e-14);
    EXPECT_LT(length(back[1] - V(4, -1, 2)), 1e-14);
    EXPECT_LT(length(back[2] - V(0, 5, 7)), 1e-14);
}

TEST(AffineTriangle, WithoutAreaIsNeverHit) {
    const auto needle = affine_triangle<float>({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    expect_miss({{1, 1, 5}, {0, 0, -1}}, needle);
    expect_miss({{0, 0, 5}, {0, 0, -1}}, affine_triangle<float>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
}

// ---- Cylinder and cone
// -----------------------------------------------------------------------------------------------

TEST(Cylinder, AcrossTheAxisFromOutsideAndInside) {
    const Cylinder<> cylinder{{0, 0, 0}, {0, 0, 4}, 2};
    expect_hit({{-5, 0, 1}, {1, 0, 0}}, cylinder, 3);
    expect_hit({{0, 0, 1}, {2, 0, 0}}, cylinder, 1);
    expect_hit({{-5, 1.2, 1}, {1, 0, 0}}, cylinder, 5 - std::sqrt(4 - 1.2 * 1.2));
    expect_normal({{-5, 0, 1}, {1, 0, 0}}, cylinder, {-1, 0, 0});
    expect_normal({{0, 0, 1}, {1, 0, 0}}, cylinder, {1, 0, 0});
}

TEST(Cylinder, EndsAreOpenAndRimsInclusive) {
    const Cylinder<> cylinder{{0, 0, 0}, {0, 0, 4}, 2};
    expect_hit({{-5, 0, 4}, {1, 0, 0}}, cylinder, 3);
    expect_hit({{-5, 0, 0}, {1, 0, 0}}, cylinder, 3);
    expect_miss({{-5, 0, 4.001}, {1, 0, 0}}, cylinder);
    expect_miss({{0, 0, 9}, {0, 0, -1}}, cylinder);     // along the axis: a = 0
    expect_miss({{2, 0, 9}, {0, 0, -1}}, cylinder);     // within the side
    expect_hit({{0, 0, 9}, {1, 0, -3.5}}, cylinder, 2); // in by the open top, out at the far side
}

TEST(Cylinder, MakerTakesTheNotesParameters) {
    const auto cylinder = cylinder_along({1, 2, 3}, {0, 0, 5}, 0.5, 7);
    EXPECT_EQ(cylinder.bottom, Vec<float>(1, 2, 3));
    EXPECT_EQ(cylinder.top, Vec<float>(1, 2, 10));
    EXPECT_EQ(cylinder.radius, 0.5f);
}

TEST(Cone, AcrossTheAxis) {
    const Cone<> cone{{0, 0, 0}, {0, 0, 2}, 1}; // radius z / 2
    expect_hit({{-5, 0, 1}, {1, 0, 0}}, cone, 4.5);
    expect_hit({{0, 0, 1}, {1, 0, 0}}, cone, 0.5);
    expect_miss({{-5, 0, 2.001}, {1, 0, 0}}, cone);
    expect_miss({{-5, 0, -1}, {1, 0, 0}}, cone); // only the mirror image is there
    expect_normal({{-5, 0, 1}, {1, 0, 0}}, cone, V(-2, 0, -1) / std::sqrt(5.0));
}

TEST(Cone, TheMirrorImageDoesNotHideTheCone) {
    const Cone<> cone{{0, 0, 0}, {0, 0, 2}, 1};
    // Steeper than the cone's side: in by the mirror image at z = -1, on into the cone at z = 3/7.
    expect_hit({{-0.9, 0, -3}, {0.2, 0, 1}}, cone, 24.0 / 7);
    // Flatter: both roots on the mirror image.
    expect_miss({{-5, 0, -1.5}, {1, 0, 0.1}}, cone);
}

TEST(Cone, AlongAGeneratorTheEquationIsLinear) {
    const Cone<> cone{{0, 0, 0}, {0, 0, 2}, 1};
    const auto t = intersect(Ray<double>{{-1, 0, 0}, {1, 0, 2}}, cone); // parallel to the line x = z / 2
    ASSERT_TRUE(t);
    EXPECT_DOUBLE_EQ(*t, 0.5);
}

TEST(Cone, RimAndApexBelongToIt) {
    const Cone<> cone{{0, 0, 0}, {0, 0, 2}, 1};
    expect_hit({{-5, 0, 2}, {1, 0, 0}}, cone, 4);
    EXPECT_EQ(intersect(Ray<double>{{-5, 0, 0}, {1, 0, 0}}, cone), 5.0);
    expect_normal({{-5, 0, 0}, {1, 0, 0}}, cone, {0, 0, -1});
}

TEST(Cone, MakerTakesTheNotesParameters) {
    const auto cone = cone_along({1, 2, 3}, {0, 0, -2}, std::atan2(3, 4), 5);
    EXPECT_LT(length(cone.base - Vec<float>(1, 2, -1)), 1e-6f);
    EXPECT_FLOAT_EQ(cone.radius, 3);
}

// ---- Box
// -------------------------------------------------------------------------------------------------------------

TEST(Box, NearestFaceFromOutside) {
    const Box<> box{{-1, -2, -3}, {1, 2, 3}};
    expect_hit({{5, 0.5, 0.5}, {-2, 0, 0}}, box, 2);
    expect_normal({{5, 0.5, 0.5}, {-2, 0, 0}}, box, {1, 0, 0});
    expect_hit({{0, -5, 0}, {0.1, 1, 0.1}}, box, 3);
    expect_normal({{0, -5, 0}, {0.1, 1, 0.1}}, box, {0, -1, 0});
    expect_miss({{5, 2.1, 0}, {-1, 0, 0}}, box);
    expect_miss({{5, 0, 0}, {1, 0, 0}}, box);
}

TEST(Box, FromInsideTheFaceThroughWhichTheRayLeaves) {
    const Box<> box{{-1, -2, -3}, {1, 2, 3}};
    expect_hit({{0, 0, 0}, {0, 0, -1}}, box, 3);
    expect_normal({{0, 0, 0}, {0, 0, -1}}, box, {0, 0, -1});
}

TEST(Box, FlatBoxesAreHit) {
    const Box<> flat{{-1, 0, -1}, {1, 0, 1}};
    const Ray<double> ray{{0.25, 3, 0.5}, {0, -1, 0}};
    EXPECT_EQ(intersect(ray, flat), 3.0);
    expect_normal(ray, flat, {0, 1, 0});
    EXPECT_FALSE(intersect_textbook(ray, flat)) << "B §4 and C ask for t_enter < t_exit";
}

TEST(Box, ARayInThePlaneOfAFaceHits) {
    const Box<> box{{-1, -1, -1}, {1, 1, 1}};
    for (const double zero : {0.0, -0.0}) {
        EXPECT_EQ(intersect(Ray<double>{{-5, 1, 0}, {1, zero, 0}}, box), 4.0);
        EXPECT_EQ(intersect(Ray<double>{{-5, -1, -1}, {1, zero, zero}}, box), 4.0);
        EXPECT_FALSE(intersect(Ray<double>{{-5, 1.5, 0}, {1, zero, 0}}, box));
    }
}

TEST(Box, TouchedAtAnEdge) {
    EXPECT_EQ(intersect(Ray<double>{{0, 2, 0}, {1, -1, 0}}, Box<>{{-1, -1, -1}, {1, 1, 1}}), 1.0);
}

// ---- What holds for every shape
// --------------------------------------------------------------------------------------

// How far a point is from the shape, in its infinite extension.
double distance_from(const Plane<> &s, const V &p) { return dot(p - V(s.point), normalize(V(s.normal))); }
double distance_from(const Disk<> &s, const V &p) {
    return std::max(std::abs(dot(p - V(s.centre), normalize(V(s.normal)))),
                    length(p - V(s.centre)) - static_cast<double>(s.radius));
}
double distance_from(const AffineTriangle<> &s, const V &p) { return dot(p - V(s.corner), normalize(V(s.normal))); }
double distance_from(const Cylinder<> &s, const V &p) {
    const V n = V(s.top) - V(s.bottom);
    return length(cross(p - V(s.bottom), n)) / length(n) - static_cast<double>(s.radius);
}
double distance_from(const Cone<> &s, const V &p) {
    const V n = V(s.base) - V(s.apex), m = p - V(s.apex);
    const double r = static_cast<double>(s.radius), l = length(n);
    return (length(cross(m, n)) - dot(m, n) * r / l) / std::hypot(l, r);
}
double distance_from(const Box<> &s, const V &p) {
    double nearest = inf;
    for (int axis = 0; axis < 3; ++axis)
        nearest = std::min({nearest, std::abs(p[axis] - static_cast<double>(s.lo[axis])),
                            std::abs(p[axis] - static_cast<double>(s.hi[axis]))});
    return nearest;
}

// Where "outside" is, from a point of the shape: a step along the normal must lead there.
template <class Shape> bool outside(const Shape &shape, const V &p) { return distance_from(shape, p) > 0; }
bool outside(const Disk<> &s, const V &p) { return dot(p - V(s.centre), V(s.normal)) > 0; }
bool outside(const Box<> &s, const V &p) {
    return !(p.x > s.lo.x && p.y > s.lo.y && p.z > s.lo.z && p.x < s.hi.x && p.y < s.hi.y && p.z < s.hi.z);
}

template <class Shape> struct EveryShape : testing::Test {};
using Shapes = testing::Types<Plane<>, Disk<>, AffineTriangle<>, Cylinder<>, Cone<>, Box<>>;
TYPED_TEST_SUITE(EveryShape, Shapes);

TYPED_TEST(EveryShape, HitsLieOnTheShapeWithAUnitOutwardNormal) {
    int hits = 0;
    for (std::uint64_t i = 0; i < 40000; ++i) {
        Random random(2, i);
        const TypeParam shape = random_shape(random, TypeParam{});
        Ray<double> ray = random_ray(random);
        ray.t_max = random.uniform(0.5, 20);
        const auto t = intersect(ray, shape);
        if (!t)
            continue;
        ++hits;
        ASSERT_TRUE(in_range(ray, *t));
        const auto hit = surface(ray, *t, shape);
        ASSERT_LT(length(hit.point - point_at(ray, *t)), 1e-11) << "case " << i;
        ASSERT_LT(std::abs(distance_from(shape, hit.point)), 1e-13) << "case " << i;
        ASSERT_NEAR(length(hit.normal), 1, 1e-15);
        ASSERT_TRUE(outside(shape, hit.point + 1e-9 * hit.normal)) << "case " << i;
    }
    EXPECT_GT(hits, 1000);
}

// Wherever a ray is long enough to have been judged alike, the two forms agree on easy, random data.
TYPED_TEST(EveryShape, BothFormsAgreeOnRandomData) {
    int different = 0;
    for (std::uint64_t i = 0; i < 40000; ++i) {
        Random random(3, i);
        const TypeParam shape = random_shape(random, TypeParam{});
        const Ray<double> ray = random_ray(random);
        const auto t = intersect(ray, shape), textbook = intersect_textbook(ray, shape);
        different += t.has_value() != textbook.has_value();
        if (t && textbook) {
            ASSERT_NEAR(*t, *textbook, 1e-8 * *t) << "case " << i;
        }
    }
    EXPECT_LE(different, 0);
}

template <class Shape> struct EveryShapeAndImplicit : testing::Test {};
using AllShapes = testing::Types<Plane<>, Disk<>, AffineTriangle<>, Cylinder<>, Cone<>, Box<>, Implicit<Torus<>>,
                                 Implicit<LatticeBlob<>>>;
TYPED_TEST_SUITE(EveryShapeAndImplicit, AllShapes);

// The default tests compute in double whatever the ray's scalar: a float ray gets the double answer, rounded.
TYPED_TEST(EveryShapeAndImplicit, AFloatRayGetsTheRoundedAnswer) {
    int hits = 0;
    for (std::uint64_t i = 0; i < 10000; ++i) {
        Random random(4, i);
        const TypeParam shape = random_shape(random, TypeParam{});
        const Ray<double> drawn = random_ray(random);
        const Ray<float> ray{Vec<float>(drawn.origin), Vec<float>(drawn.direction)};
        const auto t = intersect(ray, shape);
        const auto in_double = intersect(Ray<double>{V(ray.origin), V(ray.direction)}, shape);
        ASSERT_EQ(t.has_value(), in_double.has_value()) << "case " << i;
        if (t) {
            ASSERT_EQ(*t, static_cast<float>(*in_double)) << "case " << i;
            ++hits;
        }
    }
    EXPECT_GT(hits, 500);
}

float odd_number(Random &random) {
    constexpr float largest = std::numeric_limits<float>::max();
    constexpr float numbers[] = {0,
                                 -0.0f,
                                 1,
                                 -1,
                                 0.5f,
                                 3,
                                 1e-45f,
                                 1e20f,
                                 -1e20f,
                                 1e-20f,
                                 largest,
                                 -largest,
                                 infinity<float>,
                                 -infinity<float>,
                                 std::numeric_limits<float>::quiet_NaN()};
    return numbers[static_cast<std::size_t>(random.uniform(0, std::size(numbers)))];
}

// Odd numbers in any field: whatever is reported is a finite t within the interval, and every search ends.
TYPED_TEST(EveryShapeAndImplicit, OddNumbersNeverGiveAnOddHit) {
    for (std::uint64_t i = 0; i < 100000; ++i) {
        Random random(11, i);
        TypeParam shape = random_shape(random, TypeParam{});
        static_assert(sizeof(TypeParam) % sizeof(float) == 0);
        std::array<float, sizeof(TypeParam) / sizeof(float)> fields;
        std::memcpy(fields.data(), &shape, sizeof shape);
        for (float &field : fields)
            if (random.uniform() < 0.2)
                field = odd_number(random);
        std::memcpy(&shape, fields.data(), sizeof shape);
        Ray<double> ray = random_ray(random);
        for (int axis = 0; axis < 3; ++axis) {
            if (random.uniform() < 0.2)
                ray.origin[axis] = static_cast<double>(odd_number(random));
            if (random.uniform() < 0.2)
                ray.direction[axis] = static_cast<double>(odd_number(random));
        }
        if (const auto t = intersect(ray, shape)) {
            ASSERT_TRUE(std::isfinite(*t) && *t > 0) << "case " << i;
        }
    }
}

} // namespace
