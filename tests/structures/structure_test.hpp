// The tests that every acceleration structure passes. A structure's test program is two lines:
//
//     #include "tests/structures/structure_test.hpp"
//     COURSE_STRUCTURE_TEST(Bvh)
//
// What a structure returns is compared with brute force by the same kernels: the same id, and the same t bit for bit.
// Most of this is compiled once (structure_test.cpp): here stands what needs to know the structure's type.
#pragma once
#include "chapters/09_aabb/accelerate.hpp"
#include "chapters/09_aabb/counters.hpp"
#include "chapters/09_aabb/instance.hpp"
#include "chapters/09_aabb/one_box.hpp"
#include "tests/structures/scenes.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <variant>

namespace course::structure_test {

bool same(const Hit<double> &a, const Hit<double> &b); // bit for bit

// What is asked of a structure, and of brute force.
class Asked {
  public:
    virtual ~Asked() = default;
    virtual Id primitives() const = 0;
    virtual Hit<double> closest(const Ray<double> &ray) const = 0;
    virtual bool any(const Ray<double> &ray) const = 0;
};

template <class Built, class Base = Asked> class AskedOf : public Base {
  public:
    template <class Shape> explicit AskedOf(const std::vector<Shape> &shapes) : built(shapes) {}

    Id primitives() const override { return size(built); }
    Hit<double> closest(const Ray<double> &ray) const override { return closest_hit(ray, built); }
    bool any(const Ray<double> &ray) const override { return any_hit(ray, built); }

  protected:
    Built built;
};

// Fails unless the structure finds the same hits as brute force, and answers any_hit in the same way.
void expect_agreement(const std::string &name, const Asked &brute, const Asked &structure,
                      const std::vector<Ray<double>> &rays);

// For triangles, spheres and AnyShape.
template <class Shape> std::unique_ptr<const Asked> brute_force(const std::vector<Shape> &shapes);

// One type for the kinds of which no structure knows more than bounds and test: with it, a structure is compiled once
// for all of them.
struct AnyShape {
    std::variant<Disk<>, Box<>, Cylinder<>, Cone<>, AffineTriangle<>> kind;
};
Box<float> bounds(const AnyShape &shape);
std::optional<double> intersect(const Ray<double> &ray, const AnyShape &shape);

// At random places, sizes and angles.
std::vector<Sphere<>> random_spheres(std::size_t count, std::uint64_t seed);
// All of the kind of this number, from 0; of all kinds in turn where there is none of that number.
std::vector<AnyShape> random_shapes(std::size_t count, std::uint64_t seed, std::size_t kind);

std::vector<Ray<double>> random_rays(std::size_t count, std::uint64_t seed);

// ---- Meshes ---------------------------------------------------------------------------------------------------------

class AskedMesh : public Asked {
  public:
    // All hits along the ray, each primitive once. Nothing narrows the ray, so a walk must offer every candidate.
    virtual std::size_t hits_along(Ray<double> ray) const = 0;
};

template <class Built> class AskedMeshOf final : public AskedOf<Built, AskedMesh> {
  public:
    using AskedOf<Built, AskedMesh>::AskedOf;

    std::size_t hits_along(Ray<double> ray) const override {
        std::vector<bool> seen(this->built.shapes.slots(), false);
        std::size_t hits = 0;
        traverse(ray, this->built, [&](Id slot) {
            if (!seen[slot]) {
                seen[slot] = true;
                hits += intersect(ray, this->built.shapes[slot]).has_value();
            }
            return false;
        });
        return hits;
    }
};

using Around = std::function<std::unique_ptr<const AskedMesh>(const Mesh &)>;

void agrees_with_brute_force_on_hard_meshes(const Around &around);
void closed_meshes_neither_leak_nor_miscount(const Around &around);

template <template <class> class X> std::unique_ptr<const AskedMesh> around_mesh(const Mesh &mesh) {
    return std::make_unique<const AskedMeshOf<X<Triangle<>>>>(mesh);
}

// ---- Other shapes ---------------------------------------------------------------------------------------------------

template <template <class> class X, class Shape>
void agrees_with_brute_force_on(const std::string &name, const std::vector<Shape> &shapes) {
    expect_agreement(name, *brute_force(shapes), AskedOf<X<Shape>>(shapes), random_rays(4000, 22));
}

template <template <class> class X> void agrees_with_brute_force_on_every_shape() {
    agrees_with_brute_force_on<X>("spheres", random_spheres(300, 21));
    std::size_t kind = 0;
    for (const char *name : {"disks", "boxes", "cylinders", "cones", "affine triangles", "all kinds"})
        agrees_with_brute_force_on<X>(name, random_shapes(300, 21, kind++));
}

template <template <class> class X> void nests_and_keeps_ids() {
    const X<Triangle<>> inner(soup(80, 0.3, 31)), empty(Mesh{});
    std::vector<Instance<X<Triangle<>>>> places;
    Random random(32);
    for (int i = 0; i < 12; ++i) {
        const double angle = random.uniform(0, 6);
        const glm::dmat3 turn(2 * std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle), 0, 0, 0.2, 1);
        places.push_back({i % 4 == 1 ? &empty : &inner, placed_by(turn, Vec<double>(random_point(random, 2)))});
    }
    const AskedOf<X<Instance<X<Triangle<>>>>> outer(places);
    EXPECT_EQ(outer.primitives(), 9 * 80u);
    expect_agreement("nested", AskedOf<Scene<Instance<X<Triangle<>>>>>(places), outer, random_rays(6000, 33));

    // A structure in an object in a scene, with a plane that no structure holds: ids run through all of them.
    struct Paint {
        int number;
    };
    const Scene scene(std::vector{Plane<>{{0, 0, -3}, {0, 0, 1}}}, places, random_spheres(50, 34));
    const auto fast = accelerate<X>(scene);
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

template <template <class> class X> void counts_and_bounds_and_bytes() {
    const Mesh mesh = soup(500, 0.1, 41);
    const X<Triangle<>> built(mesh);
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

} // namespace course::structure_test

#define COURSE_STRUCTURE_TEST(X)                                                                                       \
    namespace course::structure_test {                                                                                 \
    TEST(X, AgreesWithBruteForceOnHardMeshes) { agrees_with_brute_force_on_hard_meshes(around_mesh<X>); } /* H12 */    \
    TEST(X, ClosedMeshesNeitherLeakNorMiscount) { closed_meshes_neither_leak_nor_miscount(around_mesh<X>); }           \
    TEST(X, AgreesWithBruteForceOnEveryShape) { agrees_with_brute_force_on_every_shape<X>(); }                         \
    TEST(X, NestsAndKeepsIds) { nests_and_keeps_ids<X>(); }                                                            \
    TEST(X, CountsAndBoundsAndBytes) { counts_and_bounds_and_bytes<X>(); }                                             \
    }
