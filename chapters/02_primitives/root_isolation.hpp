// Lesson 02, step 10: the first root of a function, with a proof that none lies before it.
#pragma once
#include "chapters/02_primitives/dual.hpp"

#include <optional>

namespace course {

// One end of a stretch of the t axis, and the sign of f there: -1, 1, or 0 where rounding leaves it open.
struct End {
    double t;
    int sign;
};

inline int sign_of(const Interval &x) { return x.lo > 0 ? 1 : x.hi < 0 ? -1 : 0; }

template <class F> End end_at(const F &f, double t) { return {t, sign_of(f(Interval(t)))}; }

// The root between two ends of opposite sign, where f is monotone: Newton's steps while they stay between the ends,
// bisection otherwise.
template <class F> double monotone_root(const F &f, End left, End right) {
    double t = 0.5 * (left.t + right.t);
    for (int step = 0; step < 100; ++step) {
        const Dual<double> at = f(Dual<double>(t, 1.0));
        ((at.value < 0) == (left.sign < 0) ? left.t : right.t) = t;
        const double newton = t - at.value / at.slope;
        const double next = newton > left.t && newton < right.t ? newton : 0.5 * (left.t + right.t);
        if (std::abs(next - t) <= 0x1p-50 * std::abs(t))
            return next;
        t = next;
    }
    return t;
}

// The first root of f between two ends that `accept` takes. f is one formula, evaluated in Interval, in Dual<Interval>
// and in Dual<double>. A stretch is given up only when an enclosure of f proves that it holds no root; it is searched
// by monotone_root only when an enclosure of the derivative proves that it holds at most one; else it is halved, and
// the near half goes first. So no root is skipped. A stretch that is still open when it is no longer than `finest`,
// such as where a ray touches the surface, counts as a root.
template <class F, class Accept>
std::optional<double> first_root(const F &f, const End &left, const End &right, double finest, const Accept &accept) {
    const auto accepted = [&](double t) { return accept(t) ? std::optional(t) : std::nullopt; };
    const Interval stretch(left.t, right.t);
    const Dual<Interval> over = f(Dual<Interval>(stretch, 1.0));
    if (!contains_zero(over.value))
        return {};
    if (excludes_zero(over.slope)) { // at most one root: the signs at the ends decide
        if (left.sign * right.sign > 0)
            return {};
        if (left.sign * right.sign < 0)
            return accepted(monotone_root(f, left, right));
        return accepted(left.sign == 0 ? left.t : right.t);
    }

    const double middle = 0.5 * (left.t + right.t);
    const Interval at_middle = f(Interval(middle));
    const Interval by_mean_value = at_middle + over.slope * (stretch - middle);
    if (!contains_zero(by_mean_value))
        return {};
    if (!(right.t - left.t > finest))
        return accepted(middle);

    const End centre{middle, sign_of(at_middle)};
    if (const auto root = first_root(f, left, centre, finest, accept))
        return root;
    return first_root(f, centre, right, finest, accept);
}

// Between lo and hi, as finely as a double of their size can tell.
template <class F, class Accept>
std::optional<double> first_root(const F &f, double lo, double hi, const Accept &accept) {
    const double finest = 0x1p-51 * std::max(std::abs(lo), std::abs(hi));
    return first_root(f, end_at(f, lo), end_at(f, hi), finest, accept);
}

} // namespace course
