// The tests that every acceleration structure passes. A structure's test program is two lines:
//
//     #include "tests/structures/structure_test.hpp"
//     COURSE_STRUCTURE_TEST(Bvh)
//
// What a structure returns is compared with brute force by the same kernels: the same id, and the same t bit for bit.
#pragma once
#include "chapters/09_aabb/accelerate.hpp"
#include "chapters/09_aabb/counters.hpp"
#include "chapters/09_aabb/instance.hpp"
#include "chapters/09_aabb/one_box.hpp"
#include "tests/structures/scenes.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace course::structure_test {

template <template <class> class X> struct Of { template <class Shape> using Around = X<Shape>; };

template <class T> bool same(const Hit<T> &a, const Hit<T> &b) {
    return a.id == b.id && std::memcmp(&a.t, &b.t, sizeof(T)) == 0;
}

// How many of the rays find another hit than brute force, or another answer to any_hit; reports the first.
template <class Shape, class Built>
std::size_t disagreements(const std::vector<Shape> &shapes, const Built &built, const std::vector<Ray<double>> &rays) {
    const Scene brute(shapes);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto expected = closest_hit(rays[i], brute), found = closest_hit(rays[i], built);
        const bool any = any_hit(rays[i], built);
        if (same(expected, found) && any == bool(expected))
            continue;
        if (wrong++ == 0)
            ADD_FAILURE() << "ray " << i << ": brute force finds id " << expected.id << " at " << expected.t
                          << ", the structure id " << found.id << " at " << found.t << ", any_hit says " << any;
    }
    return wrong;
}

// All hits along the ray, each primitive once. Nothing narrows the ray, so a walk must offer every candidate.
template <class Built> std::size_t hits_along(Ray<double> ray, const Built &built) {
    std::vector<bool> seen(built.shapes.slots(), false);
    std::size_t hits = 0;
    traverse(ray, built, [&](Id slot) {
        if (!seen[slot]) {
            seen[slot] = true;
            hits += intersect(ray, built.shapes[slot]).has_value();
        }
        return false;
    });
    return hits;
}

template <class Tag> class StructureTest : public ::testing::Test {
  public:
    template <class Shape> using X = typename Tag::template Around<Shape>;
    template <class Shape> static X<Shape> around(const std::vector<Shape> &shapes) {
        return X<Shape>(std::span<const Shape>(shapes));
    }
};
TYPED_TEST_SUITE_P(StructureTest);

TYPED_TEST_P(StructureTest, AgreesWithBruteForceOnHardMeshes) { // H12
    std::uint64_t seed = 100;
    for (const auto &[name, mesh, inside] : hard_meshes()) {
        SCOPED_TRACE(name);
        const auto built = this->around(mesh);
        EXPECT_EQ(size(built), mesh.size());
        EXPECT_EQ(disagreements(mesh, built, hard_rays(mesh, 4000, ++seed)), 0u);
    }
}

TYPED_TEST_P(StructureTest, ClosedMeshesNeitherLeakNorMiscount) { // H6, H7
    for (const auto &[name, mesh, inside] : hard_meshes()) {
        if (inside.empty())
            continue;
        SCOPED_TRACE(name);
        const auto built = this->around(mesh);
        Random random(7);
        std::size_t leaks = 0, even = 0;
        for (std::size_t i = 0; i < 4000; ++i) {
            const Vec<double> origin = inside[i % inside.size()];
            const auto &[a, b, c] = mesh[random.bits() % mesh.size()];
            const Vec<double> edge = Vec<double>(a) + random.uniform() * (Vec<double>(b) - Vec<double>(a));
            const Vec<double> aims[] = {Vec<double>(random_point(random)), Vec<double>(a) - origin, edge - origin};
            const Ray<double> ray{origin, aims[i % 3]};
            leaks += !closest_hit(ray, built);
            even += hits_along(ray, built) % 2 == 0;
        }
        EXPECT_EQ(leaks, 0u);
        EXPECT_EQ(even, 0u);
    }
}

// Every kind of shape at random places, sizes and angles.
template <class Shape> Shape random_shape(Random &random);
template <> inline Sphere<> random_shape(Random &random) {
    return {random_point(random), static_cast<float>(random.uniform(0.01, 0.3))};
}
template <> inline Disk<> random_shape(Random &random) {
    return {random_point(random), random_point(random), static_cast<float>(random.uniform(0.01, 0.4))};
}
template <> inline Box<> random_shape(Random &random) {
    const Vec<float> lo = random_point(random), edges = abs(random_point(random, 0.3));
    return {lo, lo + edges};
}
template <> inline Cylinder<> random_shape(Random &random) {
    const Vec<float> bottom = random_point(random);
    return {bottom, bottom + random_point(random, 0.4), static_cast<float>(random.uniform(0.01, 0.2))};
}
template <> inline Cone<> random_shape(Random &random) {
    const Vec<float> apex = random_point(random);
    return {apex, apex + random_point(random, 0.4), static_cast<float>(random.uniform(0.01, 0.3))};
}
template <> inline AffineTriangle<> random_shape(Random &random) {
    const Vec<float> a = random_point(random);
    return affine_triangle(a, a + random_point(random, 0.4f), a + random_point(random, 0.4f));
}

template <class Shape> std::vector<Shape> random_shapes(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < count; ++i)
        shapes.push_back(random_shape<Shape>(random));
    return shapes;
}

inline std::vector<Ray<double>> random_rays(std::size_t count, std::uint64_t seed) {
    return hard_rays(soup(200, 0.5, seed), count, seed);
}

TYPED_TEST_P(StructureTest, AgreesWithBruteForceOnEveryShape) {
    const auto check = [&]<class Shape>(std::type_identity<Shape>, const char *name) {
        SCOPED_TRACE(name);
        const auto shapes = random_shapes<Shape>(300, 21);
        EXPECT_EQ(disagreements(shapes, this->around(shapes), random_rays(4000, 22)), 0u);
    };
    check(std::type_identity<Sphere<>>{}, "sphere");
    check(std::type_identity<Disk<>>{}, "disk");
    check(std::type_identity<Box<>>{}, "box");
    check(std::type_identity<Cylinder<>>{}, "cylinder");
    check(std::type_identity<Cone<>>{}, "cone");
    check(std::type_identity<AffineTriangle<>>{}, "affine triangle");
}

TYPED_TEST_P(StructureTest, NestsAndKeepsIds) {
    const Mesh mesh = soup(80, 0.3, 31);
    const auto inner = this->around(mesh), empty = this->around(Mesh{});
    std::vector<Instance<std::remove_cvref_t<decltype(inner)>>> places;
    Random random(32);
    for (int i = 0; i < 12; ++i) {
        const double angle = random.uniform(0, 6);
        const glm::dmat3 turn(2 * std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle), 0, 0, 0.2, 1);
        places.push_back({i % 4 == 1 ? &empty : &inner, placed_by(turn, Vec<double>(random_point(random, 2)))});
    }
    const auto outer = this->around(places);
    EXPECT_EQ(size(outer), 9 * 80u);
    EXPECT_EQ(disagreements(places, outer, random_rays(6000, 33)), 0u);

    // A structure in an object in a scene, with a plane that no structure holds: ids run through all of them.
    struct Paint {
        int number;
    };
    const Scene scene(std::vector{Plane<>{{0, 0, -3}, {0, 0, 1}}}, places, random_shapes<Sphere<>>(50, 34));
    const auto fast = accelerate<TypeParam::template Around>(scene);
    const Scene painted(std::vector{Object{fast, Paint{5}}});
    EXPECT_EQ(size(painted), 1 + 9 * 80 + 50u);
    std::size_t wrong = 0;
    for (const Ray<double> &ray : random_rays(4000, 35)) {
        const auto expected = closest_hit(ray, scene), found = closest_hit(ray, painted);
        wrong += !same(expected, found) || any_hit(ray, painted) != bool(expected);
        if (!expected)
            continue;
        const auto normal = with_hit(ray, expected, scene, [](const auto &surface) { return surface.normal; });
        wrong += normal != with_hit(ray, found, painted, [](const auto &surface, const Paint &paint) {
                     return paint.number == 5 ? surface.normal : Vec<double>(0);
                 });
    }
    EXPECT_EQ(wrong, 0u);
}

TYPED_TEST_P(StructureTest, CountsAndBoundsAndBytes) {
    const Mesh mesh = soup(500, 0.1, 41);
    const auto built = this->around(mesh);
    Counts counts;
    std::size_t hits = 0;
    for (const Ray<double> &ray : random_rays(200, 42)) {
        const auto counted = closest_hit(CountedRay<>{ray, &counts}, built);
        EXPECT_TRUE(same(counted, closest_hit(ray, built)));
        hits += bool(counted);
    }
    EXPECT_GE(counts.tests, hits);
    EXPECT_LE(counts.tests, 200u * 500u * 8u);
    const Box<double> whole = rounded_outward<double>(bounds(built));
    for (const auto &triangle : mesh)
        for (const auto &corner : {triangle.a, triangle.b, triangle.c})
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_TRUE(whole.lo[axis] <= corner[axis] && corner[axis] <= whole.hi[axis]);
    EXPECT_GE(bytes(built), mesh.size() * sizeof(Triangle<>));
    EXPECT_FALSE(closest_hit(Ray<double>{{0, 0, 0}, {0, 0, 0}}, built)); // a ray without direction meets nothing
}

REGISTER_TYPED_TEST_SUITE_P(StructureTest, AgreesWithBruteForceOnHardMeshes, ClosedMeshesNeitherLeakNorMiscount,
                            AgreesWithBruteForceOnEveryShape, NestsAndKeepsIds, CountsAndBoundsAndBytes);

} // namespace course::structure_test

#define COURSE_STRUCTURE_TEST(X)                                                                                       \
    namespace course::structure_test {                                                                                 \
    INSTANTIATE_TYPED_TEST_SUITE_P(X, StructureTest, Of<X>);                                                           \
    }
