// The oracle against exact methods that are not its own: CGAL's geometry for flat shapes, boxes and spheres; for
// cylinder and cone, their implicit function sampled and bisected in 100 digits.
#include "common/random.hpp"
#include "tests/oracle/oracle.hpp"

#include <CGAL/Gmpq.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <optional>

using namespace course;
using exact::Answer;
using exact::Verdict;

namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

Kernel::Point_3 point(const Vec<double> &p) { return {p.x, p.y, p.z}; }
Kernel::Vector_3 vector(const Vec<double> &v) { return {v.x, v.y, v.z}; }
Kernel::Ray_3 ray_of(const Ray<double> &ray) { return {point(ray.origin), vector(ray.direction)}; }

// Small whole numbers make touches, ties and rays within faces common; floats over many scales make the rest.
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : random_(seed) {}
    double number(bool whole) {
        if (whole)
            return std::floor(random_.uniform(-4, 5));
        return static_cast<double>(static_cast<float>(random_.uniform(-1, 1) * std::exp2(random_.uniform(-8, 8))));
    }
    Vec<double> vec(bool whole) { return {number(whole), number(whole), number(whole)}; }
    Ray<double> ray(bool whole) {
        Ray<double> made{vec(whole), vec(whole)};
        while (made.direction == Vec<double>(0))
            made.direction = vec(whole);
        return made;
    }

  private:
    Random random_;
};

constexpr int cases = 20000;

// The t of an exactly known point of the ray.
double t_of(const Kernel::Ray_3 &ray, const Kernel::Point_3 &p) {
    const auto d = ray.to_vector();
    return CGAL::to_double(Kernel::FT(((p - ray.source()) * d) / (d * d)));
}

TEST(SecondOpinion, PlaneByIntersection) {
    Numbers numbers(1);
    for (int i = 0; i < cases; ++i) {
        const auto ray = numbers.ray(i % 2);
        const auto at = numbers.vec(i % 2), normal = numbers.vec(i % 2);
        if (normal == Vec<double>(0))
            continue;
        const auto line = ray_of(ray);
        const auto met = CGAL::intersection(line, Kernel::Plane_3(point(at), vector(normal)));
        const Kernel::Point_3 *p = met ? boost::get<Kernel::Point_3>(&*met) : nullptr;
        const bool hit = p && *p != line.source();
        const Answer ours = exact::plane(ray, at, normal);
        ASSERT_EQ(ours.may_hit(), hit) << i;
        if (hit) {
            ASSERT_NEAR(ours.t / t_of(line, *p), 1, 1e-12);
        }
    }
}

TEST(SecondOpinion, TriangleByIntersection) {
    Numbers numbers(2);
    int hits = 0, boundaries = 0;
    for (int i = 0; i < cases; ++i) {
        const bool whole = i % 2;
        const auto ray = numbers.ray(whole);
        const auto a = numbers.vec(whole), b = numbers.vec(whole), c = numbers.vec(whole);
        const Kernel::Triangle_3 triangle(point(a), point(b), point(c));
        if (triangle.is_degenerate())
            continue;
        const auto line = ray_of(ray);
        const auto met = CGAL::intersection(line, triangle);
        const Kernel::Point_3 *p = met ? boost::get<Kernel::Point_3>(&*met) : nullptr;
        const bool within_plane =
            triangle.supporting_plane().has_on(line.source()) && triangle.supporting_plane().has_on(line.point(1));
        const bool hit = p && *p != line.source() && !within_plane;
        const Answer ours = exact::triangle(ray, a, b, c);
        ASSERT_EQ(ours.may_hit(), hit) << i;
        if (!hit)
            continue;
        const bool rim = Kernel::Segment_3(point(a), point(b)).has_on(*p) ||
                         Kernel::Segment_3(point(b), point(c)).has_on(*p) ||
                         Kernel::Segment_3(point(c), point(a)).has_on(*p);
        ASSERT_EQ(ours.verdict, rim ? Verdict::boundary : Verdict::hit) << i;
        ASSERT_NEAR(ours.t / t_of(line, *p), 1, 1e-12);
        ++hits;
        boundaries += rim;
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(boundaries, 50);
}

TEST(SecondOpinion, BoxByDoIntersect) {
    Numbers numbers(3);
    int hits = 0;
    for (int i = 0; i < cases; ++i) {
        const auto ray = numbers.ray(i % 2);
        const auto p = numbers.vec(i % 2), q = numbers.vec(i % 2);
        const Vec<double> lo = min(p, q), hi = max(p, q);
        const bool inside_or_on = lo.x <= ray.origin.x && ray.origin.x <= hi.x && lo.y <= ray.origin.y &&
                                  ray.origin.y <= hi.y && lo.z <= ray.origin.z && ray.origin.z <= hi.z;
        if (inside_or_on || lo.x == hi.x || lo.y == hi.y || lo.z == hi.z)
            continue; // there CGAL's ray, which holds its source, and the surface differ
        const bool hit = CGAL::do_intersect(ray_of(ray), Kernel::Iso_cuboid_3(point(lo), point(hi)));
        ASSERT_EQ(exact::box(ray, lo, hi).may_hit(), hit) << i;
        hits += hit;
    }
    EXPECT_GT(hits, 500);
}

TEST(SecondOpinion, SphereByDoIntersect) {
    Numbers numbers(4);
    int hits = 0;
    for (int i = 0; i < cases; ++i) {
        const bool whole = i % 2;
        const auto ray = numbers.ray(whole);
        const auto centre = numbers.vec(whole);
        const double radius = std::abs(numbers.number(whole)) + (whole ? 1 : 0.1);
        const Kernel::Sphere_3 sphere(point(centre), Kernel::FT(radius) * radius);
        const auto line = ray_of(ray);
        if (sphere.has_on_boundary(line.source()))
            continue; // t = 0 is not in our range
        const bool hit = CGAL::do_intersect(line, sphere);
        const Answer ours = exact::sphere(ray, centre, radius);
        ASSERT_EQ(ours.may_hit(), hit) << i;
        hits += hit;
        if (hit) { // the point at t lies on the sphere, as nearly as t's last digit allows
            const auto from = line.source() + Kernel::FT(ours.t) * vector(ray.direction) - point(centre);
            const double reach = length(ray.origin - centre) + radius;
            ASSERT_NEAR(CGAL::to_double(from * from - Kernel::FT(radius) * radius), 0, 1e-11 * reach * reach);
        }
    }
    EXPECT_GT(hits, 500);
}

// ---- Cylinder and cone by sampling -------------------------------------------------------------------------------

using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
using Place = std::array<Digits, 3>;

Digits dot(const Place &a, const Place &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place place(const Vec<double> &v) { return {v.x, v.y, v.z}; }
Place minus(const Place &a, const Place &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// The first crossing of `distance` (signed, zero on the infinite surface) along the ray at which `between` holds.
template <class Distance, class Between> std::optional<double>
first_crossing(const Ray<double> &ray, double reach, const Distance &distance, const Between &between) {
    const Place o = place(ray.origin), d = place(ray.direction);
    const auto at = [&](const Digits &t) { return Place{o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]}; };
    constexpr int samples = 400;
    Digits before = distance(at(0));
    for (int i = 1; i <= samples; ++i) {
        Digits lo = reach * (i - 1) / samples, hi = reach * i / samples;
        const Digits after = distance(at(hi));
        if ((before < 0) != (after < 0)) {
            for (int halving = 0; halving < 120; ++halving) {
                const Digits middle = (lo + hi) / 2;
                ((distance(at(middle)) < 0) == (before < 0) ? lo : hi) = middle;
            }
            if (between(at(lo)))
                return static_cast<double>(lo);
        }
        before = after;
    }
    return {};
}

// surface_distance(m · n, m · m, n · n, r), with m from the first end point, tells the two shapes apart.
template <class Distance, class Exact>
void compare_with_sampling(std::uint64_t seed, const Distance &surface_distance, const Exact &oracle) {
    Numbers numbers(seed);
    int hits = 0, differing = 0;
    constexpr int rays = 1500;
    for (int i = 0; i < rays; ++i) {
        const Vec<double> p0 = numbers.vec(true) + 0.5 * numbers.vec(true), p1 = p0 + numbers.vec(true);
        if (p0 == p1)
            continue;
        const double radius = 0.25 + std::abs(numbers.number(true)) / 2;
        const Vec<double> target = p0 + 0.25 * numbers.vec(true);
        Ray<double> ray{3.0 * numbers.vec(true) + 0.125 * numbers.vec(true), {}};
        ray.direction = target - ray.origin;
        if (ray.direction == Vec<double>(0))
            continue;
        const Place base = place(p0), n = minus(place(p1), base);
        const Digits nn = dot(n, n);
        const auto sampled = first_crossing(
            ray, 12,
            [&](const Place &x) {
                const Place m = minus(x, base);
                return surface_distance(Digits(dot(m, n)), Digits(dot(m, m)), nn, Digits(radius));
            },
            [&](const Place &x) {
                const Digits height = dot(minus(x, base), n);
                return height >= 0 && height <= nn;
            });
        const Answer ours = oracle(ray, p0, p1, radius);
        const bool sampled_range = !ours.may_hit() || ours.t < 12;
        if (sampled_range && ours.may_hit() != sampled.has_value()) {
            ++differing; // two crossings, or a touch, between two samples
            EXPECT_TRUE(ours.may_hit()) << "the oracle lost a hit that sampling found, ray " << i;
        } else if (sampled && sampled_range && ours.t < *sampled - 1e-9) {
            ++differing; // the same, before the hit that sampling found
        } else if (sampled && sampled_range) {
            EXPECT_NEAR(ours.t, *sampled, 1e-12);
            ++hits;
        }
    }
    EXPECT_GT(hits, rays / 10);
    EXPECT_LT(differing, rays / 20);
}

TEST(SecondOpinion, CylinderBySampling) {
    compare_with_sampling(
        5,
        [](const Digits &h, const Digits &mm, const Digits &nn, const Digits &r) -> Digits {
            return mm - h * h / nn - r * r;
        },
        exact::cylinder);
}

TEST(SecondOpinion, ConeBySampling) {
    // Along the axis at height h / |n| the wall is r h / nn away from it.
    compare_with_sampling(
        6,
        [](const Digits &h, const Digits &mm, const Digits &nn, const Digits &r) -> Digits {
            const Digits wall = r * h / nn;
            return mm - h * h / nn - wall * wall;
        },
        exact::cone);
}

} // namespace
