// The optics of the first note as printed, failing, beside the derived forms, holding.
#include "chapters/05_texture/uv.hpp"
#include "chapters/07_glass/optics.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

// cos i0, cos i1 and the relative index n, as the note names them: light from air into glass and back.
struct Angles {
    double cos_i0, cos_i1, n;
};
Angles into_glass(double cos_i0) { return {cos_i0, refracted_cosine(cos_i0, 1, 1.5f), 1.5}; }

double reflectance_eq50(const Angles &a) {
    const double s = (a.n * a.cos_i0 - a.cos_i1) / (a.cos_i1 + a.n * a.cos_i0);
    const double p = (a.cos_i0 - a.n * a.cos_i1) / (a.n * a.cos_i1 + a.cos_i0);
    return 0.5 * (s * s + p * p);
}
double transmittance_eq58(const Angles &a) {
    const double s = a.cos_i1 + a.n * a.cos_i0, p = a.n * a.cos_i1 + a.cos_i0;
    return 2 * a.cos_i0 * a.cos_i0 * (1 / (s * s) + 1 / (p * p));
}

TEST(ErrataA, Eq58_TransmittanceLacksTheFactorThatMakesItsSumOne) {
    for (const double cos_i : {1.0, 0.8, 0.5, 0.2}) {
        const Angles a = into_glass(cos_i);
        const double printed = reflectance_eq50(a) + transmittance_eq58(a);
        const double derived = reflectance_eq50(a) + transmittance_eq58(a) * a.n * a.cos_i1 / a.cos_i0;
        EXPECT_LT(printed, 0.9);
        EXPECT_NEAR(derived, 1, 1e-15);
        EXPECT_NEAR(fresnel(cos_i, 1, 1.5f).transmitted, transmittance_eq58(a) * a.n * a.cos_i1 / a.cos_i0, 1e-15);
    }
}

TEST(ErrataA, Eq59_TheLimitIsFourNOverOnePlusNSquared) {
    const double n = 1.5, printed = std::pow(2 / (1 + n), 2), derived = 4 * n / std::pow(1 + n, 2);
    const double reflected = std::pow((n - 1) / (n + 1), 2); // eq. 51
    EXPECT_LT(reflected + printed, 0.7);
    EXPECT_NEAR(reflected + derived, 1, 1e-15);
    EXPECT_NEAR(fresnel(1, 1, 1.5f).transmitted, derived, 1e-15);
}

TEST(ErrataA, Eq50_NeedsTheCosineWithoutItsSign) {
    Angles a = into_glass(0.8);
    const double right = reflectance_eq50(a);
    a.cos_i0 = -a.cos_i0; // n_hit . n0 of a ray that comes from before the surface, as eq. 54 to 56 need it
    EXPECT_GT(reflectance_eq50(a), 1);
    EXPECT_NEAR(fresnel(0.8, 1, 1.5f).reflected, right, 1e-15);
}

TEST(ErrataA, Eq54_NeedsTheCosineWithItsSign) {
    const Vec<double> normal(0, 0, 1), d(0.6, 0, -0.8);
    const auto eq54 = [&](double cos_i0) {
        const Angles a = into_glass(std::abs(cos_i0));
        return (d - (a.n * a.cos_i1 + cos_i0) * normal) / a.n;
    };
    const Vec<double> derived = refracted_direction(d, normal, 1, 1.5f);
    EXPECT_GT(std::abs(length(eq54(0.8)) - 1), 0.1); // the absolute value of eq. 50: not even of length one
    EXPECT_LT(length(eq54(-0.8) - derived), 1e-15);
}

TEST(ErrataA, Eq55_TheRelativeIndexInvertsOnLeaving) {
    const Vec<double> normal(0, 0, 1), inside = refracted_direction({0.6, 0, -0.8}, normal, 1, 1.5f);
    const Vec<double> back = -inside; // out again: must be the way it came, turned round
    const auto eq55 = [&](double n) {
        const double cos_i0 = dot(back, normal), cos_i1 = std::sqrt(1 - (1 - cos_i0 * cos_i0) / (n * n));
        return (back + (n * cos_i1 - cos_i0) * normal) / n;
    };
    EXPECT_GT(length(eq55(1.5) - Vec<double>(-0.6, 0, 0.8)), 0.1); // the object's index, as eq. 53 says
    EXPECT_LT(length(eq55(1 / 1.5) - Vec<double>(-0.6, 0, 0.8)), 1e-14);
    EXPECT_LT(length(refracted_direction(back, normal, 1.5f, 1) - Vec<double>(-0.6, 0, 0.8)), 1e-14);
}

// A eq. 32 names e0 and e1; the frame of 3.1.6 has e2 (the pole) and e3. With the world's first two axes in their
// place, where the pole is the second, the side of a point is never seen, and half of all longitudes are wrong.
TEST(ErrataA, Eq32_MustUseTheSpheresOwnFrame) {
    const Vec<double> pole(0, 1, 0), normal = normalize(Vec<double>(0.5, 0.2, 0.7));
    const Vec<double> flat = normalize(normal - dot(normal, pole) * pole);
    const auto eq32 = [&](const Vec<double> &e0, const Vec<double> &e1) {
        const double angle = std::acos(dot(flat, e0));
        return (dot(flat, e1) >= 0 ? angle : 2 * pi - angle) / (2 * pi);
    };
    const double right = spherical_uv(normal).x;
    EXPECT_GT(std::abs(eq32({1, 0, 0}, {0, 1, 0}) - right), 0.1);
    EXPECT_NEAR(eq32({1, 0, 0}, {0, 0, -1}), right, 1e-15);
}

// And near e0 its arc cosine has lost half of the digits.
TEST(ErrataA, Eq32_TheArcCosineLosesHalfOfTheDigits) {
    const double longitude = 1e-7;
    const Vec<double> flat(std::cos(longitude), 0, -std::sin(longitude));
    EXPECT_GT(std::abs(std::acos(flat.x) / longitude - 1), 1e-4);
    EXPECT_NEAR(spherical_uv(flat).x * 2 * pi / longitude, 1, 1e-14);
}

} // namespace
