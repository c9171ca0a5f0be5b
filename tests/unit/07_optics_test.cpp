// Snell and Fresnel against exact and wider arithmetic (H13 of the hard cases).
#include "chapters/07_glass/optics.hpp"
#include "common/random.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

using namespace course;

namespace {

constexpr double ulp = 0x1p-52;
using Exact = boost::multiprecision::cpp_rational;

Vec<double> random_direction(Random &random) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

// Indices from diamond into air to air into diamond, alike on a logarithmic scale.
float random_index(Random &random) { return static_cast<float>(std::exp(random.uniform(-1, 1) * std::log(2.42))); }

bool exactly_totally_reflects(double cos_i, float n_from, float n_to) {
    const Exact from(static_cast<double>(n_from)), to(static_cast<double>(n_to)), c(cos_i);
    return from * from * (1 - c * c) > to * to;
}

TEST(TotalReflection, IsDecidedExactlyAroundTheCriticalAngle) {
    Random random(1);
    int wrong = 0, wrong_by_sine = 0, cases = 0;
    for (int i = 0; i < 40000; ++i) {
        float from = random_index(random), to = random_index(random);
        if (from < to)
            std::swap(from, to);
        const double ratio = static_cast<double>(to) / static_cast<double>(from);
        const double off = std::exp(random.uniform(std::log(1e-18), std::log(1e-2))) * (random.bits() & 1 ? 1 : -1);
        const double cos_i = std::clamp(std::sqrt(1 - ratio * ratio) * (1 + off), 0.0, 1.0);
        const bool right = exactly_totally_reflects(cos_i, from, to);
        wrong += totally_reflects(cos_i, from, to) != right;
        wrong_by_sine += (std::sqrt(1 - cos_i * cos_i) > ratio) != right;
        ++cases;
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(wrong_by_sine, cases / 100) << "the cases are hard enough to fool the formula of the textbooks";
}

TEST(TotalReflection, TheBoundaryItselfIsNone) {
    // sin 0.8 at cos 0.6: the double 0.6 lies below six tenths, and the next one above.
    EXPECT_TRUE(totally_reflects(0.6, 1.25f, 1));
    EXPECT_FALSE(totally_reflects(std::nextafter(0.6, 1), 1.25f, 1));
    for (const float n : {1.0f, 1.5f, 2.42f})
        for (const double cos_i : {0.0, 1e-300, 1e-9, 0.5, 1.0})
            EXPECT_FALSE(totally_reflects(cos_i, n, n));
    EXPECT_FALSE(totally_reflects(0, 1, 1.5f));
    EXPECT_TRUE(totally_reflects(0, 1.5f, 1));
}

TEST(Fresnel, ReflectedAndTransmittedAddUpToOne) {
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 1000000; ++i) {
        const double cos_i = i % 2 ? random.uniform() : std::exp(random.uniform(-40, 0));
        const Fresnel f = fresnel(cos_i, random_index(random), random_index(random));
        ASSERT_TRUE(f.reflected >= 0 && f.transmitted >= 0 && f.reflected <= 1);
        worst = std::max(worst, std::abs(f.reflected + f.transmitted - 1));
    }
    EXPECT_LE(worst, 2 * ulp);
    std::printf("R + T = 1 to %.2g ulp over a million angles and indices\n", worst / ulp);
}

// R and T, each by itself, against the same physics in 64 bits of mantissa, by amplitudes instead of cross terms.
TEST(Fresnel, AgreesWithWiderArithmetic) {
    Random random(3);
    for (int i = 0; i < 200000; ++i) {
        const float from = random_index(random), to = random_index(random);
        const double cos_i = random.uniform();
        const long double n = static_cast<long double>(to) / static_cast<long double>(from), c = cos_i;
        const long double sin_squared = (1 - c * c) / (n * n);
        if (sin_squared > 0.9999L)
            continue; // there, 64 bits are not enough for the reference
        const long double cos_t = std::sqrt(1 - sin_squared);
        const long double ts = 2 * c / (c + n * cos_t), tp = 2 * c / (n * c + cos_t), rs = ts - 1, rp = n * tp - 1;
        const Fresnel f = fresnel(cos_i, from, to);
        EXPECT_NEAR(f.reflected, static_cast<double>((rs * rs + rp * rp) / 2), 8 * ulp);
        EXPECT_NEAR(f.transmitted, static_cast<double>(n * cos_t / c * (ts * ts + tp * tp) / 2), 8 * ulp);
    }
}

TEST(Fresnel, NeedsNoLimitAtNormalIncidence) {
    for (const float n : {1.0001f, 1.333f, 1.5f, 2.42f, 0.5f}) {
        const double to = n, sum = 1 + to;
        for (const double i : {0.0, 1e-9, 1e-12, 1e-300}) {
            const Fresnel f = fresnel(std::cos(i), 1, n);
            EXPECT_NEAR(f.reflected, (to - 1) * (to - 1) / (sum * sum), 8 * ulp * f.reflected);
            EXPECT_NEAR(f.transmitted, 4 * to / (sum * sum), 4 * ulp);
        }
    }
}

// Light that goes the way back divides in the same proportions.
TEST(Fresnel, IsReciprocal) {
    Random random(4);
    for (int i = 0; i < 100000; ++i) {
        const float from = random_index(random), to = random_index(random);
        const double cos_i = random.uniform(0.05, 1);
        if (totally_reflects(cos_i, from, to) || refracted_cosine(cos_i, from, to) < 0.05)
            continue;
        const Fresnel there = fresnel(cos_i, from, to), back = fresnel(refracted_cosine(cos_i, from, to), to, from);
        EXPECT_NEAR(there.reflected, back.reflected, 1e-12);
        EXPECT_NEAR(there.transmitted, back.transmitted, 1e-12);
    }
}

TEST(Snell, TheSinesAreAsTheIndicesAndTheWayBackIsTheSame) {
    Random random(5);
    for (int i = 0; i < 100000; ++i) {
        const float from = random_index(random), to = random_index(random);
        const Vec<double> d = random_direction(random), n = random_direction(random);
        const double cos_i = std::abs(dot(d, n));
        if (cos_i < 0.01 || totally_reflects(cos_i, from, to) || refracted_cosine(cos_i, from, to) < 0.01)
            continue;
        const Vec<double> t = refracted_direction(d, n, from, to);
        EXPECT_NEAR(length(t), 1, 4 * ulp);
        EXPECT_GT(dot(t, n) * dot(d, n), 0);
        EXPECT_LT(length(static_cast<double>(from) * cross(d, n) - static_cast<double>(to) * cross(t, n)), 1e-14);
        EXPECT_LT(length(refracted_direction(-t, n, to, from) + d), 1e-11);
    }
}

// The cosine just before total reflection, against exact arithmetic.
TEST(Snell, TheCosineIsStableNearTheCriticalAngle) {
    for (const double off : {1e-2, 1e-4, 1e-6, 1e-8}) {
        const float from = 1.5f, to = 1;
        const double cos_i = std::sqrt(1 - 1 / 2.25) * (1 + off);
        const Exact c(cos_i), square = 1 + Exact(9, 4) * c * c - Exact(9, 4); // of the refracted cosine
        const double right = std::sqrt(square.convert_to<double>());
        EXPECT_NEAR(refracted_cosine(cos_i, from, to), right, 2 * ulp * right);
    }
}

// A hundred reflections inside a sphere: the angle of incidence stays what it was, and so does the length.
TEST(Snell, AHundredBouncesDoNotDrift) {
    Vec<double> point(1, 0, 0), direction = normalize(Vec<double>(-1, 1.7, 0.3));
    const double cosine = -dot(direction, point);
    for (int i = 0; i < 100; ++i) {
        point = normalize(point - 2 * dot(point, direction) * direction); // the far end of the chord
        EXPECT_NEAR(dot(direction, point), cosine, 1e-12);
        direction = mirror_direction(direction, point);
        EXPECT_NEAR(length(direction), 1, 1e-13);
        EXPECT_NEAR(fresnel(cosine, 1.5f, 1).reflected + fresnel(cosine, 1.5f, 1).transmitted, 1, 2 * ulp);
    }
}

} // namespace
