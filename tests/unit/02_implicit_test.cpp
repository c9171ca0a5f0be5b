// The solver for implicit surfaces: no root is skipped, judged by Sturm's theorem on the torus's quartic.
#include "chapters/02_primitives/marching.hpp"
#include "chapters/02_primitives/random_shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace course;

namespace {

using V = Vec<double>;

// ---- The judge: the quartic along the ray in long double, and Sturm's count of its roots
// -----------------------------

using Polynomial = std::vector<long double>; // coefficients from the constant up

long double value(const Polynomial &p, long double t) {
    long double sum = 0;
    for (std::size_t i = p.size(); i-- > 0;)
        sum = sum * t + p[i];
    return sum;
}

Polynomial derivative(const Polynomial &p) {
    Polynomial d;
    for (std::size_t i = 1; i < p.size(); ++i)
        d.push_back(static_cast<long double>(i) * p[i]);
    return d;
}

// Minus the remainder of a / b.
Polynomial negative_remainder(Polynomial a, const Polynomial &b) {
    while (a.size() >= b.size()) {
        const long double factor = a.back() / b.back();
        for (std::size_t i = 0; i < b.size(); ++i)
            a[a.size() - b.size() + i] -= factor * b[i];
        a.pop_back();
    }
    for (auto &coefficient : a)
        coefficient = -coefficient;
    return a;
}

struct Sturm {
    std::vector<Polynomial> chain;

    explicit Sturm(const Polynomial &p) : chain{p, derivative(p)} {
        while (chain.back().size() > 1)
            chain.push_back(negative_remainder(chain[chain.size() - 2], chain.back()));
    }
    int sign_changes(long double t) const {
        int changes = 0;
        long double last = 0;
        for (const auto &p : chain)
            if (const long double now = value(p, t); now != 0) {
                changes += last * now < 0;
                last = now;
            }
        return changes;
    }
    int roots_between(long double lo, long double hi) const { return sign_changes(lo) - sign_changes(hi); }

    // The first root in (lo, hi], which must hold one.
    long double first_root(long double lo, long double hi) const {
        for (int i = 0; i < 80; ++i) {
            const long double middle = (lo + hi) / 2;
            (roots_between(lo, middle) > 0 ? hi : lo) = middle;
        }
        return hi;
    }
};

// The torus around the z axis of the origin: (|p|² + R² - r²)² - 4 R² (x² + y²) along o + t d.
Polynomial torus_quartic(const Torus<> &torus, const Ray<double> &ray) {
    using L = long double;
    const auto dot = [](const V &a, const V &b) { return L(a.x) * L(b.x) + L(a.y) * L(b.y) + L(a.z) * L(b.z); };
    const V o = ray.origin, d = ray.direction, o_flat(o.x, o.y, 0), d_flat(d.x, d.y, 0);
    const L ring = L(torus.ring), tube = L(torus.tube), m = 4 * ring * ring;
    const L dd = dot(d, d), od = dot(o, d), k = dot(o, o) + ring * ring - tube * tube;
    return {k * k - m * dot(o_flat, o_flat), 4 * k * od - 2 * m * dot(o_flat, d_flat),
            4 * od * od + 2 * k * dd - m * dot(d_flat, d_flat), 4 * od * dd, dd * dd};
}

struct Verdicts {
    int hits = 0, false_misses = 0, false_hits = 0;
    double worst_error = 0;
};

void judge(const Torus<> &torus, const Ray<double> &ray, Verdicts &verdicts) {
    const Sturm sturm(torus_quartic(torus, ray));
    const auto t = intersect(ray, shape_of(torus));
    const bool expected = sturm.roots_between(0, 1000) > 0;
    verdicts.hits += expected;
    verdicts.false_misses += expected && !t;
    verdicts.false_hits += !expected && t;
    if (expected && t) {
        const double exact = static_cast<double>(sturm.first_root(0, 1000));
        verdicts.worst_error = std::max(verdicts.worst_error, std::abs(*t - exact) / exact);
    }
}

Torus<> random_torus(Random &random) {
    const float ring = static_cast<float>(random.uniform(0.5, 2));
    return {{0, 0, 0}, {0, 0, 1}, ring, ring * static_cast<float>(random.uniform(0.05, 0.95))};
}

TEST(ImplicitTorus, RandomRaysAgreeWithTheQuartic) {
    Verdicts verdicts;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        Random random(5, i);
        const Torus<> torus = random_torus(random);
        judge(torus, random_ray(random), verdicts);
    }
    EXPECT_GT(verdicts.hits, 5000);
    EXPECT_EQ(verdicts.false_misses, 0);
    EXPECT_EQ(verdicts.false_hits, 0);
    EXPECT_LT(verdicts.worst_error, 1e-9); // at roots that nearly coincide; see the next test
}

// Rays that graze the surface at a random point, from `off` inside to `off` outside of the tangent plane.
TEST(ImplicitTorus, GrazingRaysAgreeWithTheQuartic) {
    for (const double off : {1e-2, 1e-4, 1e-6, 1e-8}) {
        Verdicts verdicts;
        for (std::uint64_t i = 0; i < 5000; ++i) {
            Random random(6, i);
            const Torus<> torus = random_torus(random);
            const double ring = static_cast<double>(torus.ring), tube = static_cast<double>(torus.tube);
            const double around = random.uniform(0, 2 * pi), across = random.uniform(0, 2 * pi);
            const V out(std::cos(around), std::sin(around), 0), up(0, 0, 1);
            const V normal = std::cos(across) * out + std::sin(across) * up;
            const V along = normalize(cross(normal, random_vector(random, 1)));
            const V touch = ring * out + (tube + random.uniform(-off, off)) * normal;
            judge(torus, {touch - 7.0 * along, along}, verdicts);
        }
        EXPECT_GT(verdicts.hits, 1000) << "off " << off;
        EXPECT_EQ(verdicts.false_misses, 0) << "off " << off;
        EXPECT_EQ(verdicts.false_hits, 0) << "off " << off;
    }
}

// The obvious search: whatever it finds, the solver finds no later; and it steps over thin rings.
TEST(ImplicitTorus, MarchingStepsOverRootsThatTheSolverFinds) {
    int hits = 0, stepped_over = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        Random random(5, i);
        const auto ring = random_shape(random, Implicit<ThinRing>{});
        const Ray<double> ray = random_ray(random);
        const auto t = intersect(ray, ring), marched = intersect_marching(ray, ring, 100);
        if (marched) {
            ASSERT_TRUE(t) << "case " << i;
            ASSERT_LE(*t, *marched + 1e-9) << "case " << i;
        }
        hits += t.has_value();
        stepped_over += t && !marched;
    }
    EXPECT_GT(hits, 200);
    EXPECT_GT(stepped_over, hits / 20);
}

// A ray through the hole's axis plane meets a ring torus four times; each must be found when t_min has passed the last.
TEST(ImplicitTorus, EveryRootIsFoundInItsTurn) {
    const auto torus = shape_of(Torus<>{{0, 0, 0}, {0, 0, 1}, 2, 0.5f});
    Ray<double> ray{{-5, 0, 0}, {1, 0, 0}};
    for (const double expected : {2.5, 3.5, 6.5, 7.5}) {
        const auto t = intersect(ray, torus);
        ASSERT_TRUE(t);
        EXPECT_NEAR(*t, expected, 1e-14);
        ray.t_min = *t + 1e-9;
    }
    EXPECT_FALSE(intersect(ray, torus));
}

TEST(ImplicitTorus, ThroughTheHoleIsAMiss) {
    const auto torus = shape_of(Torus<>{{1, 2, 3}, {1, 1, 1}, 2, 0.5f});
    EXPECT_FALSE(intersect(Ray<double>{{-4, -3, -2}, {1, 1, 1}}, torus));
    EXPECT_FALSE(intersect(Ray<double>{{1, 2, 20}, {0, 0, 1}}, torus));
}

TEST(ImplicitTorus, TouchingCountsAsAHit) {
    const auto torus = shape_of(Torus<>{{0, 0, 0}, {0, 0, 1}, 2, 0.5f});
    EXPECT_NEAR(intersect(Ray<double>{{2.5, -5, 0}, {0, 1, 0}}, torus).value(), 5, 1e-6);
}

// ---- The free-form surface
// -------------------------------------------------------------------------------------------

// Along the diagonal of the cube, x = y = z, the equation is 3 (x² - 1)² = level.
TEST(ImplicitBlob, AlongTheDiagonalByTheClosedForm) {
    const auto blob = shape_of(LatticeBlob<>{{0, 0, 0}, 1, 0.75f});
    Ray<double> ray{{-3, -3, -3}, {1, 1, 1}};
    for (const double x : {-std::sqrt(1.5), -std::sqrt(0.5), std::sqrt(0.5), std::sqrt(1.5)}) {
        const auto t = intersect(ray, blob);
        ASSERT_TRUE(t);
        EXPECT_NEAR(*t - 3, x, 1e-14);
        ray.t_min = *t + 1e-9;
    }
    EXPECT_FALSE(intersect(ray, blob));
}

// The nearest hit against a fine march: wherever f changes its sign between two steps, a hit lies before that.
TEST(ImplicitBlob, NoSignChangeIsSkipped) {
    int hits = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(7, i);
        const auto shape = random_shape(random, Implicit<LatticeBlob<>>{});
        const Ray<double> ray = random_ray(random);
        const auto t = intersect(ray, shape);
        hits += t.has_value();
        const Span span = span_within(ray, shape.bounds);
        const double start = std::max(0.0, span.enter), step = (span.exit - start) / 2000;
        const auto f = [&](double at) {
            const V p = point_at(ray, at);
            return shape.f(p.x, p.y, p.z);
        };
        for (double at = start; at < span.exit; at += step)
            if ((f(at) < 0) != (f(at + step) < 0)) {
                ASSERT_TRUE(t) << "case " << i;
                ASSERT_LE(*t, at + step + 1e-12) << "case " << i;
                break;
            }
    }
    EXPECT_GT(hits, 500);
}

template <class F> struct EveryImplicit : testing::Test {};
using Functions = testing::Types<Torus<>, LatticeBlob<>>;
TYPED_TEST_SUITE(EveryImplicit, Functions);

TYPED_TEST(EveryImplicit, HitsLieOnTheSurfaceWithAUnitOutwardNormal) {
    int hits = 0;
    for (std::uint64_t i = 0; i < 5000; ++i) {
        Random random(8, i);
        const auto shape = random_shape(random, Implicit<TypeParam>{});
        const Ray<double> ray = random_ray(random);
        const auto t = intersect(ray, shape);
        if (!t)
            continue;
        ++hits;
        ASSERT_TRUE(in_range(ray, *t));
        const auto hit = surface(ray, *t, shape);
        const auto f = [&](const V &p) { return shape.f(p.x, p.y, p.z); };
        ASSERT_NEAR(length(hit.normal), 1, 1e-15);
        ASSERT_LT(length(hit.point - point_at(ray, *t)), 1e-6) << "case " << i;
        ASSERT_LT(f(hit.point - 1e-5 * hit.normal), 0) << "case " << i;
        ASSERT_GT(f(hit.point + 1e-5 * hit.normal), 0) << "case " << i;
    }
    EXPECT_GT(hits, 1000);
}

// The t of a hit may not depend on how far the search for the nearest hit has narrowed the ray.
TYPED_TEST(EveryImplicit, TheHitDoesNotDependOnTMax) {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        Random random(9, i);
        const auto shape = random_shape(random, Implicit<TypeParam>{});
        Ray<double> ray = random_ray(random);
        if (const auto t = intersect(ray, shape)) {
            ray.t_max = next_up(*t);
            ASSERT_EQ(intersect(ray, shape), t) << "case " << i;
            ray.t_max = *t;
            ASSERT_FALSE(intersect(ray, shape)) << "case " << i;
        }
    }
}

// ---- The solver alone
// ------------------------------------------------------------------------------------------------

const auto any = [](double) { return true; };

// A sign that rounding leaves open at the end of a stretch is a root there, not a gap between two stretches.
TEST(RootIsolation, ARootAtAnEndIsFound) {
    const auto f = [](const auto &t) { return 2.0 * t; };
    EXPECT_EQ(first_root(f, 0.0, 1.0, any), 0.0);
    EXPECT_EQ(first_root(f, -1, 0, any), 0.0);
    EXPECT_FALSE(first_root(f, 1, 2, any));
}

TEST(RootIsolation, ADoubleRootIsATouch) {
    const auto f = [](const auto &t) { return square(t - 0.3); };
    EXPECT_NEAR(first_root(f, -1, 2, any).value(), 0.3, 1e-7);
    const auto above = [](const auto &t) { return square(t - 0.3) + 1e-12; };
    EXPECT_FALSE(first_root(above, -1, 2, any));
}

TEST(RootIsolation, CloseRootsAreToldApart) {
    const auto f = [](const auto &t) { return (t - 0.3) * (t - 0.300001) * (t - 0.5); };
    double last = -1;
    for (const double expected : {0.3, 0.300001, 0.5}) {
        const auto root = first_root(f, -1, 2, [&](double t) { return t > last; });
        ASSERT_TRUE(root);
        EXPECT_NEAR(*root, expected, 1e-9);
        last = *root + 1e-8;
    }
}

// The plane y = 0 as an implicit surface, and a ray that lies in it: f is 0 along the whole way.
struct Level {
    template <class N> N operator()(const N &, const N &y, const N &) const { return y; }
};

TEST(RootIsolation, ARayWithinTheSurfaceDoesNotSearchForEver) {
    const Implicit<Level> level{{}, {{-1, -1, -1}, {1, 1, 1}}};
    const Ray<double> ray{{-5, 0, 0}, {1, 0, 0}};
    const auto t = intersect(ray, level);
    ASSERT_TRUE(t);
    EXPECT_NEAR(*t, 4, 1e-14);
    EXPECT_FALSE(intersect(Ray<double>{{-5, 0, 0}, {1, 0, 0}, 0, 4}, level));
    EXPECT_FALSE(intersect(Ray<double>{{-5, 0, 0}, {1, 0, 0}, 7}, level));
    const auto inside = intersect(Ray<float>{{0, 0, 0}, {1, 0, 0}, 0.5f}, level);
    EXPECT_TRUE(inside && *inside > 0.5f);
    EXPECT_TRUE(intersect(Ray<float>{{0, 0, 0}, {1, 0, 0}}, level));
}

// A ray that starts on the surface meets its own starting point at t = 0, which is not after t_min.
TEST(RootIsolation, TheStartingPointIsNoHit) {
    const Implicit<Level> level{{}, {{-1, -1, -1}, {1, 1, 1}}};
    EXPECT_FALSE(intersect(Ray<double>{{0, 0, 0}, {0.5, 1, 0.25}}, level));
    EXPECT_FALSE(intersect(Ray<double>{{0, 0, 0}, {0.5, -1, 0.25}}, level));
}

// ---- The arithmetic
// --------------------------------------------------------------------------------------------------

TEST(IntervalArithmetic, EnclosesTheExactResult) {
    for (std::uint64_t i = 0; i < 20000; ++i) {
        Random random(10, i);
        const double a = random.uniform(-2, 2), b = random.uniform(-2, 2);
        const long double x = a, y = b;
        const auto holds = [](const Interval &interval, long double exact) {
            return interval.lo <= exact && exact <= interval.hi && interval.lo < interval.hi;
        };
        ASSERT_TRUE(holds(Interval(a) + Interval(b), x + y));
        ASSERT_TRUE(holds(Interval(a) - Interval(b), x - y));
        ASSERT_TRUE(holds(Interval(a) * Interval(b), x * y));
        ASSERT_TRUE(holds(a * Interval(b), x * y));
        ASSERT_TRUE(holds(square(Interval(a)), x * x));
        const Interval wide(std::min(a, b), std::max(a, b)), other(-0.5, 0.25);
        const long double inner = x + (y - x) * static_cast<long double>(random.uniform());
        ASSERT_TRUE(holds(wide * other, inner * 0.125L));
        ASSERT_TRUE(holds(square(wide), inner * inner));
        ASSERT_TRUE(holds(-1.5 * wide, -1.5L * inner));
    }
}

TEST(IntervalArithmetic, SquareKnowsThatBothFactorsAreTheSame) {
    const Interval x(-1, 2);
    EXPECT_LT((x * x).lo, -1.9);
    EXPECT_GT(square(x).lo, -1e-100);
}

TEST(DualNumbers, CarryTheDerivative) {
    const Dual<double> x(3.0, 1.0), y = square(x) * x - 2.0 * x + 5.0; // x³ - 2x + 5
    EXPECT_EQ(y.value, 26);
    EXPECT_EQ(y.slope, 25);
}

} // namespace
