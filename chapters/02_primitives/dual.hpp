// Lesson 02, step 9: numbers that carry their derivative along.
#pragma once
#include "chapters/02_primitives/interval.hpp"

namespace course {

// A value and its derivative by some variable: the variable itself is {x, 1}, a constant {c, 0}. Each operation follows
// the rules of differentiation, so a formula evaluated in Dual numbers yields its own derivative. With Interval for N
// both parts are enclosures.
template <class N> struct Dual {
    N value, slope;

    constexpr Dual(double constant) : value(constant), slope(0.0) {}
    constexpr Dual(const N &v, const N &s) : value(v), slope(s) {}

    friend Dual operator+(const Dual &a, const Dual &b) { return {a.value + b.value, a.slope + b.slope}; }
    friend Dual operator+(const Dual &a, double b) { return {a.value + b, a.slope}; }
    friend Dual operator+(double a, const Dual &b) { return {a + b.value, b.slope}; }
    friend Dual operator-(const Dual &a, double b) { return {a.value - b, a.slope}; }
    friend Dual operator-(const Dual &a, const Dual &b) { return {a.value - b.value, a.slope - b.slope}; }
    friend Dual operator*(const Dual &a, const Dual &b) {
        return {a.value * b.value, a.value * b.slope + a.slope * b.value};
    }
    friend Dual operator*(double a, const Dual &b) { return {a * b.value, a * b.slope}; }
    friend Dual square(const Dual &a) { return {square(a.value), 2.0 * (a.value * a.slope)}; }
};

} // namespace course
