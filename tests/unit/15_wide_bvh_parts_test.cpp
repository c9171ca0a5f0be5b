// The parts of the wide BVH: every option and mode answers as brute force does, and no bound may be any tighter.
#include "chapters/15_wide_bvh/in_flight.hpp"
#include "tests/structures/scenes.hpp"

#include <cstring>
#include <gtest/gtest.h>

namespace {

using namespace course;
namespace hard = course::structure_test;

using Rays = std::vector<Ray<double>>;

bool differ(const Hit<double> &a, const Hit<double> &b) { return a.id != b.id || std::memcmp(&a.t, &b.t, 8) != 0; }

// Over all hard meshes, how many rays get another answer than from brute force.
template <class Count> std::size_t wrong_on_hard_meshes(Count count) {
    std::size_t wrong = 0;
    std::uint64_t seed = 700;
    for (const auto &[name, mesh, inside] : hard::hard_meshes()) {
        const Rays rays = hard::hard_rays(mesh, 1500, ++seed);
        std::vector<Hit<double>> expected;
        for (const auto &ray : rays)
            expected.push_back(closest_hit(ray, Scene(mesh)));
        wrong += count(mesh, rays, expected);
    }
    return wrong;
}

template <WideOptions Options> std::size_t wrong_with() {
    return wrong_on_hard_meshes([](const hard::Mesh &mesh, const Rays &rays, const auto &expected) {
        const WideBvhBy<Triangle<>, Options> bvh{std::span<const Triangle<>>(mesh)};
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
            wrong += differ(expected[i], closest_hit(rays[i], bvh)) || any_hit(rays[i], bvh) != bool(expected[i]);
        return wrong;
    });
}

TEST(WideBvh, EveryStepOfTheLessonIsExact) {
    EXPECT_EQ(wrong_with<WideOptions{}>(), 0u);
    EXPECT_EQ(wrong_with<WideOptions{.collapse = WideOptions::Collapse::greedy}>(), 0u);
    EXPECT_EQ(wrong_with<WideOptions{.leaf = WideOptions::Leaf::one_by_one}>(), 0u);
    EXPECT_EQ(wrong_with<WideOptions{.order = WideOptions::Order::distance}>(), 0u);
    EXPECT_EQ((wrong_with<WideOptions{.one_hit_path = false, .any_hit_loop = false, .quick_t = false}>()), 0u);
}

TEST(WideBvh, NoBoundMayShrink) {
    EXPECT_GT(wrong_with<WideOptions{.slab_pad = 0}>(), 0u);
    EXPECT_GT(wrong_with<WideOptions{.edge_bound = 0}>(), 0u);
    EXPECT_GT(wrong_with<WideOptions{.depth_bound = 0}>(), 0u);
    EXPECT_GT(wrong_with<WideOptions{.clear_bound = 0}>(), 0u);
}

TEST(WideBvh, RaysInFlightAnswerLikeOneAfterTheOther) {
    const std::size_t wrong = wrong_on_hard_meshes([](const hard::Mesh &mesh, const Rays &rays, const auto &expected) {
        const WideBvh<Triangle<>> bvh{std::span<const Triangle<>>(mesh)};
        std::size_t bad = 0, answers = 0;
        InFlight<double, WideOptions{}> flights(bvh);
        for (const bool any : {false, true})
            flights(rays, any, [&](std::size_t i, const Hit<double> &hit) {
                ++answers;
                bad += any ? bool(hit) != bool(expected[i]) : differ(hit, expected[i]);
            });
        return bad + (answers != 2 * rays.size());
    });
    EXPECT_EQ(wrong, 0u);
}

// The cut by dynamic programming is never dearer than the greedy one, and no child is lost in either.
TEST(WideBvh, HoldsEveryTriangleOnceInEitherTree) {
    const hard::Mesh mesh = hard::soup(3000, 0.1, 5);
    const auto check = [&]<WideOptions Options>() {
        const WideBvhBy<Triangle<>, Options> bvh{std::span<const Triangle<>>(mesh)};
        std::vector<int> seen(mesh.size(), 0);
        for (const WideNode &node : bvh.tree.nodes)
            for (unsigned i = 0; i < lanes; ++i)
                if (node.planes[0][0][i] <= node.planes[0][1][i] && node.links[i].is_leaf())
                    for (unsigned lane = 0; lane < node.links[i].count(); ++lane)
                        ++seen[bvh.shapes.leaf(node.links[i]).ids[lane]];
        EXPECT_EQ(std::ranges::count(seen, 1), std::ssize(seen));
        return bvh.tree.nodes.size();
    };
    EXPECT_LT(check.operator()<WideOptions{}>(),
              (check.operator()<WideOptions{.collapse = WideOptions::Collapse::greedy}>()));
}

} // namespace
