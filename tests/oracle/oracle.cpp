// Each shape's decision is written once, for any number type. It runs first with CGAL's intervals, whose comparison
// throws when the interval leaves the answer open, and then, only for those cases, with exact rationals.
#include "tests/oracle/oracle.hpp"

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace course::exact {
namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

std::atomic<unsigned long long> answers_given{0}, rationals_needed{0};

template <class N> using Vector = std::array<N, 3>;

template <class N> Vector<N> exactly(const Vec<double> &v) { return {N(v.x), N(v.y), N(v.z)}; }
template <class N> Vector<N> operator-(const Vector<N> &a, const Vector<N> &b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class N> N dot(const Vector<N> &a, const Vector<N> &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
template <class N> Vector<N> cross(const Vector<N> &a, const Vector<N> &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The sign of a number; an interval that holds both signs throws Uncertain_conversion_exception.
template <class N> int sign_of(const N &x) {
    const CGAL::Sign s = CGAL::sign(x);
    return s == CGAL::POSITIVE ? 1 : s == CGAL::NEGATIVE ? -1 : 0;
}

// The sign of A + B sqrt(D), D >= 0, without taking the root.
template <class N> int sign_of(const N &A, const N &B, const N &D) {
    const int a = sign_of(A), b = sign_of(B) * sign_of(D);
    if (a == b || b == 0)
        return a;
    if (a == 0)
        return b;
    return a * sign_of(N(A * A - B * B * D));
}

// The middle of the interval that holds t. One that is too wide to judge a float's last digit by is left to rationals.
double middle(const Interval &t) {
    const double lo = t.inf(), hi = t.sup();
    if (!(hi - lo <= 0x1p-44 * std::min(std::abs(lo), std::abs(hi))) && lo != hi)
        throw CGAL::Uncertain_conversion_exception("t is too wide");
    return lo + 0.5 * (hi - lo);
}
Interval interval_of(const Interval &x) { return x; }
Interval interval_of(const Rational &x) { return CGAL::to_interval(x); }

template <class N> double quotient(const N &numerator, const N &denominator) {
    if (sign_of(numerator) == 0)
        return 0;
    const Interval::Protector rounding;
    return middle(interval_of(numerator) / interval_of(denominator));
}

// Whether numerator / denominator lies in the ray's range.
template <class N> bool in_range(const Line &ray, const N &numerator, const N &denominator) {
    const int side = sign_of(denominator);
    return side * sign_of(N(numerator - N(ray.t_min) * denominator)) > 0 &&
           (!std::isfinite(ray.t_max) || side * sign_of(N(numerator - N(ray.t_max) * denominator)) < 0);
}

// Runs decide(number), first with intervals, then, if they leave it open, with rationals.
template <class Decide> Answer decided(const Decide &decide) {
    answers_given.fetch_add(1, std::memory_order_relaxed);
    try {
        const Interval::Protector rounding;
        return decide(Interval());
    } catch (const CGAL::Uncertain_conversion_exception &) {
        rationals_needed.fetch_add(1, std::memory_order_relaxed);
        return decide(Rational());
    }
}

// ---- Quadrics: a t² + 2 b t + c = 0 -------------------------------------------------------------------------------

template <class N> struct Quadratic { N a, b, c; };

// The root (-b + side sqrt(D)) / a; of the two ways to write it, the one that does not cancel.
template <class N> double root(const Quadratic<N> &q, const N &D, int side) {
    if (sign_of(q.c) == 0 && side * sign_of(q.b) >= 0)
        return 0;
    const Interval::Protector rounding;
    const Interval b = interval_of(q.b), s = CGAL::sqrt(interval_of(D));
    if (sign_of(q.b) * side > 0)
        return middle(interval_of(q.c) / (-b - Interval(side) * s));
    return middle((-b + Interval(side) * s) / interval_of(q.a));
}

// The nearest root in range whose height mn + t dn lies in [0, nn]; a sphere has no such bound and hands in zeros.
template <class N> Answer nearest_root(const Line &ray, const Quadratic<N> &q, const N &mn, const N &dn, const N &nn) {
    const int curve = sign_of(q.a);
    if (curve == 0) { // a straight line: 2 b t + c = 0
        if (sign_of(q.b) == 0)
            return {};
        const N twice_b = N(2) * q.b, t_above = -q.c;
        const int side = sign_of(twice_b);
        const bool between = side * sign_of(N(mn * twice_b + t_above * dn)) >= 0 &&
                             side * sign_of(N((mn - nn) * twice_b + t_above * dn)) <= 0;
        if (between && in_range(ray, t_above, twice_b))
            return {Verdict::hit, quotient(t_above, twice_b)};
        return {};
    }
    const N D = q.b * q.b - q.a * q.c;
    if (sign_of(D) < 0)
        return {};
    for (const int side : {-curve, curve}) { // the smaller root first, whatever the sign of a
        // With t = (-b + side sqrt(D)) / a, the sign of x + t y is that of a times (x a - b y) + side y sqrt(D).
        const auto sign_at = [&](const N &x, const N &y) {
            return curve * sign_of(N(x * q.a - q.b * y), N(N(side) * y), D);
        };
        const bool beyond_min = sign_at(N(-ray.t_min), N(1)) > 0;
        const bool before_max = !std::isfinite(ray.t_max) || sign_at(N(-ray.t_max), N(1)) < 0;
        if (beyond_min && before_max && sign_at(mn, dn) >= 0 && sign_at(N(mn - nn), dn) <= 0)
            return {Verdict::hit, root(q, D, side)};
    }
    return {};
}

// Whether a coordinate plane through the ray's origin has the ray on one side and the whole triangle on the other. To
// compare doubles is exact, and settles most triangles of a mesh.
bool turned_away(const Line &ray, const Point &a, const Point &b, const Point &c) {
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if ((d >= 0 && std::max({a[axis], b[axis], c[axis]}) < o) ||
            (d <= 0 && std::min({a[axis], b[axis], c[axis]}) > o))
            return ray.t_min >= 0;
    }
    return false;
}

} // namespace

// ---- Flat shapes ---------------------------------------------------------------------------------------------------

Answer plane(const Line &ray, const Point &point, const Vec<double> &normal) {
    return decided([&]<class N>(N) -> Answer {
        const auto o = exactly<N>(ray.origin), d = exactly<N>(ray.direction), n = exactly<N>(normal);
        const N along = dot(n, d), gap = dot(n, exactly<N>(point) - o);
        if (sign_of(along) == 0 || !in_range(ray, gap, along))
            return {};
        return {Verdict::hit, quotient(gap, along)};
    });
}

Answer disk(const Line &ray, const Point &centre, const Vec<double> &normal, double radius) {
    return decided([&]<class N>(N) -> Answer {
        const auto d = exactly<N>(ray.direction), n = exactly<N>(normal);
        const auto to_centre = exactly<N>(centre) - exactly<N>(ray.origin);
        const N along = dot(n, d), gap = dot(n, to_centre);
        if (sign_of(along) == 0 || !in_range(ray, gap, along))
            return {};
        // The hit seen from the centre, times `along`.
        const Vector<N> p{gap * d[0] - along * to_centre[0], gap * d[1] - along * to_centre[1],
                          gap * d[2] - along * to_centre[2]};
        const N reach = N(radius) * along;
        if (sign_of(N(dot(p, p) - reach * reach)) > 0)
            return {};
        return {Verdict::hit, quotient(gap, along)};
    });
}

Answer triangle(const Line &ray, const Point &a, const Point &b, const Point &c) {
    if (turned_away(ray, a, b, c))
        return {};
    return decided([&]<class N>(N) -> Answer {
        const auto o = exactly<N>(ray.origin), d = exactly<N>(ray.direction);
        const auto A = exactly<N>(a) - o, B = exactly<N>(b) - o, C = exactly<N>(c) - o;
        const auto n = cross(B - A, C - A);
        const N along = dot(n, d), gap = dot(n, A);
        const int side = sign_of(along);
        if (side == 0 || !in_range(ray, gap, along))
            return {};
        // The ray passes each edge on its inner side, or not: the volumes that it spans with the edges.
        const int u = side * sign_of(dot(d, cross(B, C))), v = side * sign_of(dot(d, cross(C, A))),
                  w = side * sign_of(dot(d, cross(A, B)));
        if (u < 0 || v < 0 || w < 0)
            return {};
        return {u && v && w ? Verdict::hit : Verdict::boundary, quotient(gap, along)};
    });
}

Answer affine_triangle(const Line &ray, const Point &corner, const Vec<double> &normal, const Vec<double> &k1,
                       const Vec<double> &k2) {
    return decided([&]<class N>(N) -> Answer {
        const auto d = exactly<N>(ray.direction), n = exactly<N>(normal);
        const auto m = exactly<N>(ray.origin) - exactly<N>(corner);
        const N along = dot(n, d), gap = -dot(n, m);
        const int side = sign_of(along);
        if (side == 0 || !in_range(ray, gap, along))
            return {};
        // k · (m + t d), times `along`.
        const auto coordinate = [&](const Vec<double> &k) {
            return N(dot(exactly<N>(k), m) * along + gap * dot(exactly<N>(k), d));
        };
        const N u = coordinate(k1), v = coordinate(k2);
        if (side * sign_of(u) < 0 || side * sign_of(v) < 0 || side * sign_of(N(along - u - v)) < 0)
            return {};
        return {Verdict::hit, quotient(gap, along)};
    });
}

Answer box(const Line &ray, const Point &lo, const Point &hi) {
    return decided([&]<class N>(N) -> Answer {
        struct Fraction {
            N numerator, denominator; // the denominator is positive
        };
        const auto less = [](const Fraction &a, const Fraction &b) {
            return sign_of(N(a.numerator * b.denominator - b.numerator * a.denominator)) < 0;
        };
        std::array<Fraction, 3> enter, leave;
        std::size_t axes = 0;
        for (const int i : {0, 1, 2}) {
            const N o(ray.origin[i]), d(ray.direction[i]);
            const N to_lo = N(lo[i]) - o, to_hi = N(hi[i]) - o;
            const int side = sign_of(d);
            if (side == 0) {
                if (sign_of(to_lo) > 0 || sign_of(to_hi) < 0)
                    return {};
                continue;
            }
            enter[axes] = side > 0 ? Fraction{to_lo, d} : Fraction{-to_hi, -d};
            leave[axes] = side > 0 ? Fraction{to_hi, d} : Fraction{-to_lo, -d};
            ++axes;
        }
        if (axes == 0)
            return {};
        const auto count = static_cast<std::ptrdiff_t>(axes);
        const Fraction in = *std::max_element(enter.begin(), enter.begin() + count, less);
        const Fraction out = *std::min_element(leave.begin(), leave.begin() + count, less);
        if (less(out, in))
            return {};
        for (const Fraction &t : {in, out})
            if (in_range(ray, t.numerator, t.denominator))
                return {Verdict::hit, quotient(t.numerator, t.denominator)};
        return {};
    });
}

// ---- Round shapes --------------------------------------------------------------------------------------------------

Answer sphere(const Line &ray, const Point &centre, double radius) {
    return decided([&]<class N>(N) -> Answer {
        const auto d = exactly<N>(ray.direction), m = exactly<N>(ray.origin) - exactly<N>(centre);
        return nearest_root<N>(ray, {dot(d, d), dot(d, m), dot(m, m) - N(radius) * N(radius)}, N(0), N(0), N(0));
    });
}

Answer cylinder(const Line &ray, const Point &bottom, const Point &top, double radius) {
    return decided([&]<class N>(N) -> Answer {
        const auto p = exactly<N>(bottom), d = exactly<N>(ray.direction);
        const auto m = exactly<N>(ray.origin) - p, n = exactly<N>(top) - p;
        const N nn = dot(n, n), dn = dot(d, n), mn = dot(m, n), r(radius);
        return nearest_root<N>(
            ray, {nn * dot(d, d) - dn * dn, nn * dot(d, m) - dn * mn, nn * (dot(m, m) - r * r) - mn * mn}, mn, dn, nn);
    });
}

Answer cone(const Line &ray, const Point &apex, const Point &base, double radius) {
    return decided([&]<class N>(N) -> Answer {
        const auto p = exactly<N>(apex), d = exactly<N>(ray.direction);
        const auto m = exactly<N>(ray.origin) - p, n = exactly<N>(base) - p;
        const N nn = dot(n, n), dn = dot(d, n), mn = dot(m, n), k = nn + N(radius) * N(radius);
        // (x · n)² (nn + r²) = nn² |x|²: the angle to the axis is that of the wall (both nappes; the height picks one).
        return nearest_root<N>(
            ray,
            {nn * nn * dot(d, d) - k * dn * dn, nn * nn * dot(d, m) - k * dn * mn, nn * nn * dot(m, m) - k * mn * mn},
            mn, dn, nn);
    });
}

bool totally_reflects(double cosine, double n_from, double n_to) {
    const Rational c(cosine), from(n_from), to(n_to);
    return from * from * (Rational(1) - c * c) > to * to;
}

Tally tally() { return {answers_given, rationals_needed}; }

} // namespace course::exact
