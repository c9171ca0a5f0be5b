// The guards under fire: coordinates over many scales, with zeros and repeats that make ties, touches and coplanar rays
// common; every answer of every default test is the oracle's.
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/closed_meshes.hpp"
#include "tests/hard_cases/measure.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

using namespace course;
using namespace course::hard;

namespace {

// Draws floats; one in seven is one that it has drawn before, or zero.
class Fuzz {
  public:
    Fuzz(std::uint64_t seed, std::uint64_t index, int scales) : random_(seed, index), scales_(scales) {}

    double number() {
        if (random_.bits() % 7 == 0)
            return random_.bits() % 3 == 0 || drawn_.empty() ? 0.0 : drawn_[random_.bits() % drawn_.size()];
        const double made = as_float(random_.uniform(-1, 1) * std::exp2(random_.uniform(-scales_, scales_)));
        drawn_.push_back(made);
        return made;
    }
    Vec<double> vec() { return {number(), number(), number()}; }
    Vec<float> float_vec() { return Vec<float>(vec()); }
    float radius() { return static_cast<float>(std::exp2(random_.uniform(-scales_, scales_))); }

    // One ray in three is aimed at a place that the shape is made of.
    Ray<double> ray(const Vec<double> &place) {
        const Vec<double> eye = vec();
        return {eye, random_.bits() % 3 == 0 ? as_float(place - eye) : vec()};
    }

  private:
    Random random_;
    double scales_;
    std::vector<double> drawn_;
};

template <class Shape> Shape fuzzed(Fuzz &fuzz) {
    if constexpr (std::is_same_v<Shape, Sphere<>>)
        return {fuzz.float_vec(), fuzz.radius()};
    else if constexpr (std::is_same_v<Shape, Plane<>>)
        return {fuzz.float_vec(), fuzz.float_vec()};
    else if constexpr (std::is_same_v<Shape, Triangle<>>)
        return {fuzz.float_vec(), fuzz.float_vec(), fuzz.float_vec()};
    else if constexpr (std::is_same_v<Shape, AffineTriangle<>>)
        return {fuzz.float_vec(), fuzz.float_vec(), fuzz.float_vec(), fuzz.float_vec()};
    else if constexpr (std::is_same_v<Shape, Box<>>) {
        const Vec<float> p = fuzz.float_vec(), q = fuzz.float_vec();
        return {min(p, q), max(p, q)};
    } else
        return {fuzz.float_vec(), fuzz.float_vec(), fuzz.radius()};
}

template <class Shape> Vec<double> a_place_on(const Shape &shape) {
    Vec<float> first;
    static_assert(sizeof(Shape) >= sizeof first);
    std::memcpy(&first, &shape, sizeof first);
    return Vec<double>(first);
}

template <class Shape> class Guards : public testing::Test {};
using Shapes = testing::Types<Sphere<>, Plane<>, Disk<>, Triangle<>, AffineTriangle<>, Box<>, Cylinder<>, Cone<>>;
TYPED_TEST_SUITE(Guards, Shapes);

TYPED_TEST(Guards, AnswerAsTheOracleDoes) {
    Tally floats, doubles;
    for (const int scales : {1, 4, 10})
        for (std::uint64_t i = 0; i < 30'000; ++i) {
            Fuzz fuzz(static_cast<std::uint64_t>(scales), i, scales);
            const auto shape = fuzzed<TypeParam>(fuzz);
            const Ray<double> ray = fuzz.ray(a_place_on(shape));
            const auto ask = [&](const Ray<double> &asked) {
                const auto truth = exact::answer(asked, shape);
                const auto in_double = intersect(asked, shape);
                const auto in_float =
                    intersect(Ray<float>{Vec<float>(asked.origin), Vec<float>(asked.direction),
                                         static_cast<float>(asked.t_min), static_cast<float>(asked.t_max)},
                              shape);
                doubles.judge(truth, in_double ? *in_double : hard::no_hit);
                floats.judge(truth, in_float ? static_cast<double>(*in_float) : hard::no_hit);
                return truth;
            };
            const auto truth = ask(ray);
            if (truth.verdict != exact::Verdict::hit || !(truth.t > 1e-30 && truth.t < 1e30))
                continue;
            // Beyond the hit the next one counts; an interval that ends before it holds none, and one behind it the
            // same.
            ask({ray.origin, ray.direction, as_float(1.01 * truth.t)});
            ask({ray.origin, ray.direction, 0, as_float(0.999 * truth.t)});
            ask({ray.origin, ray.direction, 0, as_float(1.001 * truth.t)});
        }
    for (const Tally &tally : {floats, doubles}) {
        EXPECT_EQ(tally.false_misses, 0u);
        EXPECT_EQ(tally.false_hits, 0u);
        EXPECT_EQ(tally.nan, 0u);
        EXPECT_LE(tally.t_error_max, 1);
        EXPECT_GT(tally.t_errors.size(), 50u); // it did hit something
    }
}

// Each aim at a closed mesh gives as many rays as it is asked for, not the same few over and over.
TEST(ClosedMeshes, AreSeenAlongManyRays) {
    for (const hard::ClosedMesh &closed : hard::closed_meshes())
        for (std::size_t aim = 0; aim < hard::aims.size(); ++aim) {
            Random random(1, aim);
            std::set<std::array<double, 6>> rays;
            for (int i = 0; i < 1000; ++i) {
                const auto [o, d, t_min, t_max] = hard::ray_from_inside(random, closed, aim);
                rays.insert({o.x, o.y, o.z, d.x, d.y, d.z});
            }
            EXPECT_GT(rays.size(), 500u) << closed.name << ", " << hard::aims[aim];
        }
}

// The default tests' thresholds can be missed: a textbook kernel in their place does.
TEST(Thresholds, ATextbookKernelInPlaceOfTheDefaultMisses) {
    const auto far_sphere = [](Random &random) {
        const Sphere<> sphere{{0, 0, -1e4f}, 1};
        return Case<Sphere<>>{aimed(random, {0, 0, 0}, {random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), -1e4}),
                              sphere};
    };
    const auto outcome_of = [&](auto intersect_one) {
        const hard::Primitive<Sphere<>> primitive{
            "sphere", {kernel<float, Sphere<>>("one", intersect_one, true)}, {{"H1", "far", far_sphere}}, far_sphere};
        Settings settings;
        settings.cases = 4000;
        settings.timing_rounds = 1;
        return measure(primitive, settings);
    };
    EXPECT_TRUE(outcome_of([](const auto &ray, const auto &sphere) { return intersect(ray, sphere); }).passed);
    EXPECT_FALSE(
        outcome_of([](const auto &ray, const auto &sphere) { return intersect_textbook(ray, sphere); }).passed);
}

TEST(DoubleDoubleNumbers, KeepTwiceTheDigits) {
    const DoubleDouble third = DoubleDouble(1) / DoubleDouble(3);
    EXPECT_LT(std::abs(static_cast<double>(third * DoubleDouble(3) - DoubleDouble(1))), 0x1p-102);
    const DoubleDouble root = square_root(DoubleDouble(2));
    EXPECT_LT(std::abs(static_cast<double>(root * root - DoubleDouble(2))), 0x1p-100);
    const DoubleDouble sum = DoubleDouble(1e16) + DoubleDouble(1) - DoubleDouble(1e16);
    EXPECT_EQ(static_cast<double>(sum), 1);
    EXPECT_EQ(two_product(1 + 0x1p-30, 1 + 0x1p-30).low, 0x1p-60);
}

} // namespace
