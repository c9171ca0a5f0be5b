// Lesson 02, step 8: numbers that know what they do not know.
#pragma once
#include <algorithm>
#include <cmath>

namespace course {

// All numbers from lo to hi. An operation returns an interval that holds every result that its arguments allow: each
// bound is computed and then moved outwards by more than its rounding error, so the promise holds in floating point.
struct Interval {
    double lo, hi;

    constexpr Interval(double exactly) : lo(exactly), hi(exactly) {}
    constexpr Interval(double low, double high) : lo(low), hi(high) {}
};

// False for NaN, of which neither is known.
inline bool contains_zero(const Interval &x) { return x.lo <= 0 && x.hi >= 0; }
inline bool excludes_zero(const Interval &x) { return x.lo > 0 || x.hi < 0; }

// One to two units in the last place further out on each side, which covers the half unit of one rounding, and a little
// more for results that underflow: so much that no product of two such bounds underflows itself, which would be slow.
inline Interval outward(double lo, double hi) {
    constexpr double least = 1e-150;
    return {lo - (std::abs(lo) * 0x1p-52 + least), hi + (std::abs(hi) * 0x1p-52 + least)};
}

inline Interval operator+(const Interval &a, const Interval &b) { return outward(a.lo + b.lo, a.hi + b.hi); }
inline Interval operator-(const Interval &a, const Interval &b) { return outward(a.lo - b.hi, a.hi - b.lo); }
inline Interval operator*(const Interval &a, const Interval &b) {
    const double ll = a.lo * b.lo, lh = a.lo * b.hi, hl = a.hi * b.lo, hh = a.hi * b.hi;
    return outward(std::min(std::min(ll, lh), std::min(hl, hh)), std::max(std::max(ll, lh), std::max(hl, hh)));
}
inline Interval operator*(double a, const Interval &b) {
    const double lo = a * b.lo, hi = a * b.hi;
    return outward(std::min(lo, hi), std::max(lo, hi));
}

// Tighter than x * x, which does not know that both factors are the same number.
inline double square(double x) { return x * x; }
inline Interval square(const Interval &x) {
    const double a = x.lo * x.lo, b = x.hi * x.hi;
    return outward(contains_zero(x) ? 0 : std::min(a, b), std::max(a, b));
}

} // namespace course
