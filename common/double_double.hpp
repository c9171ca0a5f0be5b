// Numbers of twice a double's length: the sum of two doubles, the second below half an ulp of the first (Dekker 1971).
// For the few decisions that a double leaves open; some twenty times slower than a double.
#pragma once
#include "common/vectors.hpp"

#include <array>
#include <cmath>

namespace course {

struct DoubleDouble {
    double high = 0, low = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value) : high(value) {}
    constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
    explicit operator double() const { return high + low; }
};

// a + b = high + low exactly (Knuth); with |a| >= |b| three operations are enough (Dekker).
inline DoubleDouble two_sum(double a, double b) {
    const double sum = a + b, part_of_b = sum - a;
    return {sum, (a - (sum - part_of_b)) + (b - part_of_b)};
}
inline DoubleDouble quick_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

// a b = high + low exactly: the fused operation keeps what the rounded product lost.
inline DoubleDouble two_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

// Each operation is within 2^-102 of the exact result of its operands (Joldes, Muller, Popescu 2017, "accurate" sum).
inline DoubleDouble operator-(const DoubleDouble &a) { return {-a.high, -a.low}; }
inline DoubleDouble operator+(const DoubleDouble &a, const DoubleDouble &b) {
    const DoubleDouble high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
    const DoubleDouble sum = quick_two_sum(high.high, high.low + low.high);
    return quick_two_sum(sum.high, sum.low + low.low);
}
inline DoubleDouble operator-(const DoubleDouble &a, const DoubleDouble &b) { return a + -b; }
inline DoubleDouble operator*(const DoubleDouble &a, const DoubleDouble &b) {
    const DoubleDouble product = two_product(a.high, b.high);
    return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
inline DoubleDouble operator/(const DoubleDouble &a, const DoubleDouble &b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high / b.high;
    const DoubleDouble last = rest - b * DoubleDouble(second);
    return quick_two_sum(first, second) + DoubleDouble(last.high / b.high);
}
inline bool operator<(const DoubleDouble &a, const DoubleDouble &b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}

// Of a number that is not negative: one step of Newton's method from the root in double.
inline DoubleDouble square_root(const DoubleDouble &x) {
    if (!(x.high > 0))
        return 0;
    const double root = std::sqrt(x.high);
    const DoubleDouble rest = x - two_product(root, root);
    return quick_two_sum(root, rest.high / (2 * root));
}
inline double square_root(double x) { return std::sqrt(x); }

// Half of the distance from 1 to the next number: what one operation may be off by, relatively.
template <class N> inline constexpr double rounding_of = 0x1p-53;
template <> inline constexpr double rounding_of<DoubleDouble> = 0x1p-102;

// Vectors of either kind of number, so that a formula is written once and run in both.
template <class N> using Triple = std::array<N, 3>;

template <class N> Triple<N> operator-(const Triple<N> &a, const Triple<N> &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class N> N dot(const Triple<N> &a, const Triple<N> &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
template <class N> Triple<N> cross(const Triple<N> &a, const Triple<N> &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class N, class T> Triple<N> triple(const Vec<T> &v) {
    return {N(static_cast<double>(v.x)), N(static_cast<double>(v.y)), N(static_cast<double>(v.z))};
}

// The sum of the components' sizes: at least the length, at most 1.74 times it.
template <class N> double size_of(const Triple<N> &v) {
    return std::abs(static_cast<double>(v[0])) + std::abs(static_cast<double>(v[1])) +
           std::abs(static_cast<double>(v[2]));
}
inline double size_of(const Vec<double> &v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

} // namespace course
