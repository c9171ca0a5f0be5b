// The mesh triangle seen edge-on, by rays at an angle down to 2^-50 to its plane: the oracle's answers nonetheless.
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/suite.hpp"
#include "tests/oracle/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

using namespace course;
using namespace course::hard;

namespace {

// Whole numbers, so that a ray can run as nearly within a plane as one likes: with n = f1 x f2, some direction has
// n · d = gcd(n), the least that is not 0, however long d and n are.
using Whole = std::array<std::int64_t, 3>;

Whole sum(const Whole &a, std::int64_t k, const Whole &b) {
    return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}
std::int64_t dot(const Whole &a, const Whole &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole cross(const Whole &a, const Whole &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec<double> vec(const Whole &a) {
    return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}
double length(const Whole &a) { return std::sqrt(glm::dot(vec(a), vec(a))); }

// x, y with a x + b y = gcd(a, b) (Euclid).
std::array<std::int64_t, 2> bezout(std::int64_t a, std::int64_t b) {
    std::int64_t x = 1, y = 0, next_x = 0, next_y = 1;
    while (b != 0) {
        const std::int64_t quotient = a / b;
        a = std::exchange(b, a - quotient * b);
        x = std::exchange(next_x, x - quotient * next_x);
        y = std::exchange(next_y, y - quotient * next_y);
    }
    return a < 0 ? std::array{-x, -y} : std::array{x, y};
}

// A short step off the plane of f1 and f2, to the nearest parallel plane that holds whole numbers.
Whole step_off(const Whole &f1, const Whole &f2, const Whole &n) {
    if (dot(f1, f1) == 0 || dot(f2, f2) == 0)
        return {};
    const auto [p, q] = bezout(n[0], n[1]);
    const auto [r, s] = bezout(std::gcd(n[0], n[1]), n[2]);
    Whole step{p * r, q * r, s};
    for (int round = 0; round < 50; ++round)
        for (const Whole &f : {f1, f2})
            step = sum(step, -std::llround(glm::dot(vec(step), vec(f)) / glm::dot(vec(f), vec(f))), f);
    return step;
}

struct EdgeOn {
    Triangle<> triangle;
    Ray<double> ray;
    double slope; // the sine of the angle between the ray and the plane
};

EdgeOn edge_on(Random &random) {
    const auto whole = [&](int bits) {
        return static_cast<std::int64_t>(random.bits() % (2u << bits)) - (std::int64_t{1} << bits);
    };
    const int size = 3 + static_cast<int>(random.bits() % 12); // bits of the triangle's sides over 8
    Whole f1, f2, n, step;
    do {
        f1 = {whole(size), whole(size), whole(size)};
        f2 = {whole(size), whole(size), whole(size)};
        n = cross(f1, f2);
        step = step_off(f1, f2, n);
    } while (n[0] == 0 || n[1] == 0 || n[2] == 0 || length(step) > 2 * (length(f1) + length(f2)));
    const Whole a{whole(16), whole(16), whole(16)};
    const int reach = 21 - size;
    Whole d = sum(sum({}, whole(reach), f1), whole(reach), f2);
    d = sum(d, 1 + random.bits() % 3, step);
    // A place of the plane, in the triangle or up to one step outside, and the ray's way from there backwards.
    const Whole place = sum(sum(a, static_cast<std::int64_t>(random.bits() % 11) - 1, f1), random.bits() % 10, f2);
    const Whole eye = sum(place, -1 - static_cast<std::int64_t>(random.bits() % 3), d);
    const double scale = std::exp2(static_cast<double>(whole(4)));
    const auto corner = [&](const Whole &p) { return Vec<float>(scale * vec(p)); };
    return {{corner(a), corner(sum(a, 8, f1)), corner(sum(a, 8, f2))},
            {scale * vec(eye), scale * vec(sum({}, 1 + random.bits() % 3, d))},
            std::abs(static_cast<double>(dot(n, d))) / (length(n) * length(d))};
}

TEST(MeshTriangle, AnswersAsTheOracleDoesSeenEdgeOn) {
    Tally floats, doubles;
    double least = 1;
    int hits = 0, edges = 0;
    for (std::uint64_t i = 0; i < 100'000; ++i) {
        Random random(50, i);
        const auto [triangle, ray, slope] = edge_on(random);
        const Ray<float> float_ray{Vec<float>(ray.origin), Vec<float>(ray.direction)};
        ASSERT_EQ(ray.origin, Vec<double>(float_ray.origin)); // nothing was rounded
        ASSERT_EQ(ray.direction, Vec<double>(float_ray.direction));
        least = std::min(least, slope);
        const auto truth = exact::answer(ray, triangle);
        const auto in_double = intersect(ray, triangle);
        const auto in_float = intersect(float_ray, triangle);
        doubles.judge(truth, in_double ? *in_double : hard::no_hit);
        floats.judge(truth, in_float ? static_cast<double>(*in_float) : hard::no_hit);
        hits += truth.verdict == exact::Verdict::hit;
        edges += truth.verdict == exact::Verdict::boundary;
    }
    EXPECT_LT(least, 0x1p-50);
    EXPECT_GT(hits, 10'000);
    EXPECT_GT(edges, 10'000);
    for (const Tally &tally : {floats, doubles}) {
        EXPECT_EQ(tally.false_misses, 0u);
        EXPECT_EQ(tally.false_hits, 0u);
        EXPECT_EQ(tally.nan, 0u);
        EXPECT_LE(tally.t_error_max, 1);
    }
}

} // namespace
