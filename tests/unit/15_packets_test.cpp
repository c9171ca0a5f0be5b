// Packets of rays, however badly they suit each other, answer as each ray does alone.
#include "chapters/15_wide_bvh/packet.hpp"
#include "tests/structures/scenes.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace {

using namespace course;
namespace hard = course::structure_test;

using Rays = std::vector<Ray<double>>;

bool differ(const Hit<double> &a, const Hit<double> &b) { return a.id != b.id || std::memcmp(&a.t, &b.t, 8) != 0; }

// How many of the rays get another answer in packets of so many than from brute force.
std::size_t wrong_in_packets(const Rays &rays, const hard::Mesh &mesh, std::size_t together) {
    const WideBvh<Triangle<>> bvh{std::span<const Triangle<>>(mesh)};
    const Scene brute(mesh);
    std::size_t wrong = 0;
    for (std::size_t first = 0; first < rays.size(); first += together) {
        const auto some = std::span(rays).subspan(first, std::min(together, rays.size() - first));
        std::array<Hit<double>, lanes> hits;
        std::array<bool, lanes> any;
        closest_hits(some, bvh, std::span(hits).first(some.size()));
        any_hits(some, bvh, std::span(any).first(some.size()));
        for (std::size_t i = 0; i < some.size(); ++i) {
            const auto expected = closest_hit(some[i], brute);
            wrong += differ(expected, hits[i]) || any[i] != bool(expected);
        }
    }
    return wrong;
}

std::size_t wrong_on_hard_meshes(const auto &rays_at, std::size_t together) {
    std::size_t wrong = 0;
    std::uint64_t seed = 800;
    for (const auto &[name, mesh, inside] : hard::hard_meshes()) {
        const std::size_t here = wrong_in_packets(rays_at(mesh, ++seed), mesh, together);
        EXPECT_EQ(here, 0u) << name << ", " << together << " together";
        wrong += here;
    }
    return wrong;
}

// Neighbours have nothing in common: origins, directions, intervals.
TEST(Packets, OfRaysThatGoAnywhere) {
    for (const std::size_t together : {1, 3, 7, 8})
        EXPECT_EQ(wrong_on_hard_meshes(
                      [](const auto &mesh, std::uint64_t seed) { return hard::hard_rays(mesh, 800, seed); }, together),
                  0u);
}

// Eight rays from one place through neighbouring points, some of them along an axis, with 0 and -0.
TEST(Packets, OfRaysSideBySide) {
    const auto rays_at = [](const hard::Mesh &mesh, std::uint64_t seed) {
        Random random(seed);
        Rays rays;
        for (const auto &centre : hard::hard_rays(mesh, 200, seed)) {
            const double spread = std::pow(10, random.uniform(-9, 0)) * length(centre.direction);
            for (unsigned i = 0; i < lanes; ++i) {
                Ray<double> ray = centre;
                ray.direction += spread * Vec<double>(i % 4, i / 4, 0);
                if (random.bits() % 8 == 0)
                    ray.direction[static_cast<int>(random.bits() % 3)] = random.bits() % 2 ? 0.0 : -0.0;
                rays.push_back(ray);
            }
        }
        return rays;
    };
    EXPECT_EQ(wrong_on_hard_meshes(rays_at, lanes), 0u);
}

// From neighbouring places to one: shadow rays. And some that end before they begin, or have no direction.
TEST(Packets, OfRaysThatMeet) {
    const auto rays_at = [](const hard::Mesh &mesh, std::uint64_t seed) {
        Random random(seed);
        Rays rays;
        for (const auto &centre : hard::hard_rays(mesh, 200, seed)) {
            const Vec<double> goal = centre.origin + centre.direction;
            const double spread = std::pow(10, random.uniform(-9, 0)) * length(centre.direction);
            for (unsigned i = 0; i < lanes; ++i) {
                const Vec<double> from = centre.origin + spread * Vec<double>(hard::random_point(random));
                Ray<double> ray{from, goal - from, 0, random.uniform(0.5, 1.5)};
                if (random.bits() % 16 == 0)
                    ray.t_max = 0;
                if (random.bits() % 16 == 0)
                    ray.direction = Vec<double>(0);
                rays.push_back(ray);
            }
        }
        return rays;
    };
    EXPECT_EQ(wrong_on_hard_meshes(rays_at, lanes), 0u);
}

TEST(Packets, OfNoRays) {
    const hard::Mesh mesh = hard::soup(10, 0.5, 1);
    const WideBvh<Triangle<>> bvh{std::span<const Triangle<>>(mesh)};
    closest_hits({}, bvh, {});
    any_hits({}, bvh, {});
}

// A box that the whole group misses is left out for all of them.
TEST(Packets, LeaveOutWhatNoneOfThemMeets) {
    WideNode node;
    for (auto &[low, high] : node.planes)
        for (unsigned i = 0; i < lanes; ++i) {
            low[i] = static_cast<float>(2 * i);
            high[i] = static_cast<float>(2 * i + 1);
        }
    Rays rays;
    for (unsigned i = 0; i < lanes; ++i)
        rays.push_back({{-1, 4.1 + 0.1 * i, 4.5}, {1, 0, 0}}); // through box 2 alone
    const RayLanes together(rays, {Vec<float>(0), Vec<float>(15)}, 1);
    EXPECT_EQ(Beam(together, 255)(node, infinity<float>), 4u);
    EXPECT_EQ(together.meeting(node, 2, 0), 255u);
    EXPECT_EQ(together.meeting(node, 3, 0), 0u);
    EXPECT_EQ(together.going_like(0), 255u);
}

} // namespace
