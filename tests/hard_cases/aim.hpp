// The pieces that hard cases are made of: floats at chosen places, and rays that pass a chosen place in a chosen way.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "common/random.hpp"

#include <cmath>

namespace course::hard {

// The nearest float, as a double.
inline double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }
inline Vec<double> as_float(const Vec<double> &v) { return Vec<double>(Vec<float>(v)); }

inline Vec<double> unit_vector(Random &random) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
}

inline Vec<double> in_cube(Random &random, double half) {
    return {random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
}

// A unit vector at right angles to `axis` (which need not be unit), every such alike.
inline Vec<double> across(Random &random, const Vec<double> &axis) {
    const Vec<double> unit = normalize(axis);
    for (;;) {
        const Vec<double> v = unit_vector(random), side = v - dot(v, unit) * unit;
        if (dot(side, side) > 1e-4)
            return normalize(side);
    }
}

// Between low and high with every order of magnitude alike.
inline double over_scales(Random &random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}

inline double either_sign(Random &random) { return random.bits() % 2 ? 1 : -1; }

// The float ray from `origin` towards `target`, its direction of any length between a half and two times the way.
inline Ray<double> aimed(Random &random, const Vec<double> &origin, const Vec<double> &target) {
    const Vec<double> from = as_float(origin);
    return {from, as_float((target - from) * over_scales(random, 0.5, 2))};
}

} // namespace course::hard
