// Lesson 07, step 1: what happens to light where two clear media meet: its new directions (Snell) and how it divides
// between them (Fresnel).
#pragma once
#include "chapters/06_whitted/mirror.hpp"
#include "chapters/07_glass/exact_sign.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// Light comes through the medium with index n_from, at an angle to the normal whose cosine is cos_i, to a boundary
// with a medium with index n_to. Snell: n_from sin i = n_to sin t. Where that asks for a sine above 1 nothing passes.
// Squared, with sin² = 1 - cos²: total reflection is n_from² - n_to² > (n_from cos i)², decided without rounding.
inline bool totally_reflects(double cos_i, float n_from, float n_to) {
    if (n_from <= n_to)
        return false;
    const double from = n_from, to = n_to, excess = (from - to) * (from + to), along = from * cos_i;
    const double difference = excess - along * along;
    if (std::abs(difference) > 0x1p-50 * excess) // four roundings of 2^-53 each
        return difference > 0;
    return sign_of_excess(cos_i, from, to) > 0;
}

// The cosine of the refracted angle, right to some two ulp for the cosine that is given, up to the very edge of total
// reflection, where 1 - (n_from / n_to)² sin² i would cancel: (n_to cos t)² = n_to² - n_from² + (n_from cos i)². The
// indices are floats, so the difference of their squares is exact in double; fma() adds the square without rounding it,
// and the last term is what rounding took off n_from cos i. 0 where the light totally reflects.
inline double refracted_cosine(double cos_i, float n_from, float n_to) {
    const double from = n_from, to = n_to, along = from * cos_i, lost = std::fma(from, cos_i, -along);
    const double square = std::fma(along, along, (to - from) * (to + from)) + 2 * along * lost;
    return std::sqrt(std::max(0.0, square)) / to;
}

// The shares of unpolarised light that a boundary mirrors and lets through.
struct Fresnel {
    double reflected, transmitted;
};

// Fresnel's equations, the mean of both polarisations (A eq. 50 and 58). With a and b the indices times cosines, light
// divides in the proportion (a - b)² : 4 a b; the two add up to (a + b)². No formula divides by a small number, so that
// a limit for normal incidence (A eq. 51 and 59) is not needed, and since both shares are divided by the same computed
// sum, R + T = 1 to two ulp.
inline Fresnel fresnel(double cos_i, float n_from, float n_to) {
    if (totally_reflects(cos_i, n_from, n_to))
        return {1, 0};
    const double from = n_from, to = n_to, cos_t = refracted_cosine(cos_i, n_from, n_to);
    const auto divide = [](double a, double b) {
        const double mirrored = (a - b) * (a - b), passed = 4 * a * b, sum = mirrored + passed;
        return sum > 0 ? Fresnel{mirrored / sum, passed / sum} : Fresnel{1, 0}; // light that just grazes the boundary
    };
    const Fresnel across = divide(from * cos_i, to * cos_t); // polarised across the plane of incidence
    const Fresnel within = divide(to * cos_i, from * cos_t); // and in it
    return {0.5 * (across.reflected + within.reflected), 0.5 * (across.transmitted + within.transmitted)};
}

// The direction of light that passes (of length one), for a direction and an outward normal of length one (A eq. 54
// and 55 with the cosine's sign put right). The ray may come from either side. Only where light passes.
inline Vec<double> refracted_direction(const Vec<double> &direction, const Vec<double> &normal, float n_from,
                                       float n_to) {
    const double along = dot(direction, normal), cos_i = std::min(std::abs(along), 1.0);
    const double ratio = static_cast<double>(n_from) / static_cast<double>(n_to);
    const double change = ratio * cos_i - refracted_cosine(cos_i, n_from, n_to);
    return normalize(ratio * direction + (along < 0 ? change : -change) * normal);
}

} // namespace course
