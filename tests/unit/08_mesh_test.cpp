// Meshes: watertight from inside in every direction, parity, brute force, normals, faults.
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/03_light_and_shadow/object.hpp"
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "chapters/08_mesh/ball.hpp"
#include "chapters/08_mesh/inside.hpp"
#include "chapters/08_mesh/load.hpp"
#include "chapters/08_mesh/moller_trumbore.hpp"
#include "chapters/08_mesh/normals.hpp"
#include "common/random.hpp"

#include <gtest/gtest.h>

using namespace course;

namespace {

Vec<double> in_ball(Random &random, double radius) {
    while (true) {
        const Vec<double> p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        if (dot(p, p) < 1)
            return radius * p;
    }
}

// Points of the mesh to aim at: in a triangle, on an edge, or a corner. Rounded to double, so seldom exactly there.
enum class Aim { face, edge, corner };
Vec<double> aim_at(Random &random, const Mesh<> &mesh, Aim aim) {
    const Triangle<> flat = triangle(mesh, random.bits() % size(mesh));
    const Vec<double> a(flat.a), b(flat.b), c(flat.c);
    const double u = random.uniform(), v = random.uniform() * (1 - u);
    switch (aim) {
    case Aim::face:
        return a + u * (b - a) + v * (c - a);
    case Aim::edge:
        return a + u * (b - a);
    default:
        return a;
    }
}

// From inside, a ray leaves a closed mesh an odd number of times, and a convex one once.
void expect_watertight(const Mesh<> &mesh, const Vec<double> &centre, double inner_radius, bool exactly_once) {
    Random random(11);
    for (const Aim aim : {Aim::face, Aim::edge, Aim::corner})
        for (int i = 0; i < 4000; ++i) {
            const Vec<double> origin = centre + in_ball(random, inner_radius);
            const Vec<double> direction = aim_at(random, mesh, aim) - origin;
            const auto hits = count_hits(Ray<double>{origin, direction}, mesh);
            ASSERT_EQ(hits % 2, 1u);
            if (exactly_once) {
                ASSERT_EQ(hits, 1u);
            }
            const Ray<float> rounded{Vec<float>(origin), Vec<float>(direction)};
            ASSERT_EQ(count_hits(rounded, mesh) % 2, 1u);
        }
}

TEST(Mesh, TheBallIsWatertight) { expect_watertight(ball(2), Vec<double>(0), 0.7, true); }

TEST(Mesh, WatertightAtEveryScaleAndFarAway) {
    for (const float scale : {1e-6f, 1e-3f, 1e3f, 1e6f})
        expect_watertight(ball(1, scale), Vec<double>(0), 0.5 * static_cast<double>(scale), true);
    const Vec<float> far(148376, 1234, -223423);
    Mesh<> moved = ball(2, 100);
    for (Vec<float> &point : moved.points)
        point += far;
    expect_watertight(moved, Vec<double>(far), 50, false);
}

TEST(Mesh, NeedlesAndLatticesAreWatertight) {
    Mesh<> needles = ball(2);
    for (Vec<float> &point : needles.points)
        point.z *= 1e-4f;
    expect_watertight(needles, Vec<double>(0), 0.5e-4, false);
    Mesh<> lattice = ball(2, 8);
    for (Vec<float> &point : lattice.points)
        point = round(point);
    expect_watertight(lattice, Vec<double>(0), 4, false);
    // Along the axes and through lattice points exactly.
    for (int x = -3; x <= 3; ++x)
        for (int y = -3; y <= 3; ++y)
            for (int axis = 0; axis < 3; ++axis)
                for (const double sign : {-1.0, 1.0}) {
                    Ray<double> ray{Vec<double>(0), Vec<double>(0)};
                    ray.origin[(axis + 1) % 3] = x;
                    ray.origin[(axis + 2) % 3] = y;
                    ray.direction[axis] = sign;
                    EXPECT_EQ(count_hits(ray, lattice) % 2, 1u);
                }
}

// What the default is for: the naive forms lose rays that aim at edges or corners.
TEST(Mesh, MollerTrumboreLeaks) {
    const Mesh<> mesh = ball(2);
    Random random(5);
    int lost_strict = 0, lost = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec<double> origin = in_ball(random, 0.7);
        const Ray<float> ray{Vec<float>(origin), Vec<float>(aim_at(random, mesh, Aim::edge) - origin)};
        lost_strict += !count_hits(ray, mesh, [](auto &r, const auto &f) { return moller_trumbore_strict(r, f); });
        lost += !count_hits(ray, mesh, [](auto &r, const auto &f) { return moller_trumbore(r, f); });
    }
    EXPECT_GT(lost_strict, 0);
    EXPECT_GE(lost_strict, lost);
}

TEST(Mesh, MollerTrumboreStrictLosesTheEdge) {
    const Triangle<> left{{0, 0, 0}, {0, 2, 0}, {-2, 0, 0}}, right{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    const Ray<double> ray{{0, 1, 3}, {0, 0, -1}};
    EXPECT_FALSE(moller_trumbore_strict(ray, left) || moller_trumbore_strict(ray, right));
    EXPECT_TRUE(moller_trumbore(ray, left) && moller_trumbore(ray, right));
    EXPECT_TRUE(intersect(ray, left).has_value() != intersect(ray, right).has_value());
}

TEST(Mesh, AllFormsAgreeInsideATriangle) {
    Random random(2);
    for (int i = 0; i < 5000; ++i) {
        const auto corner = [&] { return Vec<float>(in_ball(random, 1)); };
        const Triangle<> flat{corner(), corner(), corner()};
        const Vec<double> origin = in_ball(random, 3), a(flat.a);
        const Vec<double> target = a + 0.3 * (Vec<double>(flat.b) - a) + 0.4 * (Vec<double>(flat.c) - a);
        const Ray<double> ray{origin, target - origin};
        const Vec<double> area = area_vector(flat);
        if (std::abs(dot(area, ray.direction)) < 1e-2 * length(area))
            continue; // grazing: the target's own rounding moves the hit
        for (const auto t : {moller_trumbore_strict(ray, flat), moller_trumbore(ray, flat), intersect(ray, flat)}) {
            ASSERT_TRUE(t);
            EXPECT_NEAR(*t, 1, 1e-9);
        }
    }
}

TEST(Mesh, InsideIsOdd) {
    const Mesh<> mesh = ball(3);
    Random random(9);
    for (int i = 0; i < 500; ++i) {
        const Vec<double> p = in_ball(random, 1.5);
        if (std::abs(length(p) - 0.995) >
            0.006) { // between the ball's inscribed and circumscribed spheres both are right
            EXPECT_EQ(is_inside(mesh, p), length(p) < 1);
        }
    }
}

TEST(Mesh, BruteForceIsTheSceneOfItsTriangles) {
    const Mesh<> mesh = ball(2);
    const Scene<Triangle<>> scene(triangles(mesh));
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const Ray<double> ray{in_ball(random, 2), in_ball(random, 1)};
        const auto a = closest_hit(ray, mesh), b = closest_hit(ray, scene);
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.t, b.t);
        EXPECT_EQ(any_hit(ray, mesh), static_cast<bool>(a));
        if (a) {
            EXPECT_EQ(with_hit(ray, a, mesh, [](const auto &s) { return s.id; }), a.id);
        }
    }
}

TEST(Mesh, DuplicatesGoToTheLowerId) {
    Mesh<> mesh = ball(0);
    const auto copy = mesh.indices;
    mesh.indices.insert(mesh.indices.end(), copy.begin(), copy.end());
    mesh.indices.push_back({0, 0, 1});
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const auto hit = closest_hit(Ray<double>{in_ball(random, 0.5), in_ball(random, 1)}, mesh);
        ASSERT_TRUE(hit);
        EXPECT_LT(hit.id, 20u);
    }
    const MeshFaults faults = count_faults(mesh);
    EXPECT_EQ(faults.duplicates, 20u);
    EXPECT_EQ(faults.without_area, 1u);
}

TEST(Mesh, SmoothNormalsOfABallPointOutwards) {
    Mesh<> mesh = ball(3);
    mesh.normals = normals_by_angle(mesh);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        EXPECT_GT(dot(mesh.normals[i], mesh.points[i]), 0.9999f);
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const Ray<double> ray{Vec<double>(0), in_ball(random, 1)};
        const auto hit = closest_hit(ray, mesh);
        with_hit(ray, hit, mesh, [&](const auto &s) {
            const Vec<double> n = shading_normal(mesh, s.id, s.point);
            EXPECT_NEAR(length(n), 1, 1e-12);
            EXPECT_GT(dot(n, normalize(s.point)), 0.9998);
            EXPECT_GT(dot(s.normal, s.point), 0);
        });
    }
    // At a corner it is the corner's.
    EXPECT_GT(
        dot(shading_normal(mesh, 7, Vec<double>(triangle(mesh, 7).b)), Vec<double>(mesh.normals[mesh.indices[7][1]])),
        1 - 1e-6);
}

// A cube, each side cut into two triangles: weighted by angle, every corner's normal is the diagonal, however the sides
// were cut.
TEST(Mesh, NormalsDoNotDependOnTheCut) {
    const Mesh<> cube{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                      {{0, 2, 1},
                       {0, 3, 2},
                       {4, 5, 6},
                       {4, 6, 7},
                       {0, 1, 5},
                       {0, 5, 4},
                       {2, 3, 7},
                       {2, 7, 6},
                       {1, 2, 6},
                       {1, 6, 5},
                       {3, 0, 4},
                       {3, 4, 7}}};
    const auto normals = normals_by_angle(cube);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(dot(normals[i], normalize(cube.points[i] - 0.5f)), 1, 1e-6);
    EXPECT_TRUE(is_inside(cube, {0.5, 0.5, 0.5}, {1, 1, 1})); // exactly through the corner where six triangles meet
    EXPECT_FALSE(is_inside(cube, {-1, -1, -1}, {1, 1, 1}));
}

// A spawned ray neither meets its own triangle again nor slips out through a neighbour.
TEST(Mesh, SpawnedRaysNeitherStickNorLeak) {
    for (const float scale : {1e-3f, 1.0f, 1e6f}) {
        const Mesh<> mesh = ball(2, scale);
        Random random(6);
        for (int i = 0; i < 3000; ++i) {
            const Vec<double> origin = in_ball(random, 0.5 * static_cast<double>(scale));
            const Ray<double> ray{origin, aim_at(random, mesh, i % 2 ? Aim::face : Aim::edge) - origin};
            const auto hit = closest_hit(ray, mesh);
            ASSERT_TRUE(hit);
            with_hit(ray, hit, mesh, [&](const auto &s) {
                Vec<double> out = in_ball(random, 1);
                if (dot(out, s.normal) < 0)
                    out = -out;
                EXPECT_FALSE(any_hit(spawn_ray(s, out), mesh));
                EXPECT_TRUE(any_hit(spawn_ray(s, -out), mesh));
            });
        }
    }
}

} // namespace
