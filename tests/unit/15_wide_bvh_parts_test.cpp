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
    EXPECT_EQ(wrong_with<WideOptions{.leaf = WideOptions::Leaf::compact}>(), 0u);
    EXPECT_EQ(wrong_with<WideOptions{.order = WideOptions::Order::distance}>(), 0u);
    EXPECT_EQ((wrong_with<WideOptions{.any_hit_loop = false, .quick_t = false}>()), 0u);
    EXPECT_EQ(wrong_with<WideOptions{.two_nodes = false}>(), 0u);
    EXPECT_EQ((wrong_with<WideOptions{.two_nodes = false, .one_hit_path = true}>()), 0u);
}

TEST(WideBvh, NoBoundMayShrink) {
    EXPECT_GT(wrong_with<WideOptions{.slab_pad = 0}>(), 0u);
    EXPECT_GT(wrong_with<WideOptions{.edge_bound = 0}>(), 0u);
    EXPECT_GT(wrong_with<WideOptions{.depth_bound = 0}>(), 0u);
    EXPECT_GT(wrong_with<WideOptions{.clear_bound = 0}>(), 0u);
}

template <WideOptions Options> std::size_t wrong_in_flight() {
    return wrong_on_hard_meshes([](const hard::Mesh &mesh, const Rays &rays, const auto &expected) {
        const WideBvhBy<Triangle<>, Options> bvh{std::span<const Triangle<>>(mesh)};
        std::size_t bad = 0, answers = 0;
        InFlight<double, Options> flights(bvh);
        for (const bool any : {false, true}) {
            const auto done = [&](std::size_t i, const Hit<double> &hit) {
                ++answers;
                bad += any ? bool(hit) != bool(expected[i]) : differ(hit, expected[i]);
            };
            flights(rays, any, done);
            flights(
                rays.size(), [&](std::size_t i) { return Ray<double>(rays[i]); }, any, done); // made on the way
        }
        return bad + (answers != 4 * rays.size());
    });
}

TEST(WideBvh, RaysInFlightAnswerLikeOneAfterTheOther) {
    EXPECT_EQ(wrong_in_flight<WideOptions{}>(), 0u);
    EXPECT_EQ(wrong_in_flight<WideOptions{.leaf = WideOptions::Leaf::compact}>(), 0u);
}

// Directions of any length, and places so far out that what a ray multiplies no longer fits into a float.
TEST(WideBvh, CountsInUnitsThatFitIntoAFloat) {
    for (const float size : {1e-30f, 1.0f, 1e30f}) {
        hard::Mesh mesh = hard::soup(300, 0.3, 7);
        for (auto &[a, b, c] : mesh)
            a *= size, b *= size, c *= size;
        const WideBvh<Triangle<>> bvh{std::span<const Triangle<>>(mesh)};
        for (const double length : {1e-35, 1e-7, 1.0, 1e7, 1e35}) {
            std::size_t wrong = 0, hits = 0;
            for (Ray<double> ray : hard::hard_rays(hard::soup(300, 0.3, 7), 800, 8)) {
                ray.origin *= static_cast<double>(size);
                ray.direction *= length;
                const auto expected = closest_hit(ray, Scene(mesh));
                hits += bool(expected);
                wrong += differ(expected, closest_hit(ray, bvh)) || any_hit(ray, bvh) != bool(expected);
            }
            EXPECT_EQ(wrong, 0u) << "size " << size << ", length " << length;
            EXPECT_GT(hits, 100u) << "size " << size << ", length " << length;
        }
    }
}

// Triangles so small beside their distance that floats hardly tell on which side of an edge a ray passes: they may be
// sure of each edge and not of the area. Each is seen alone, and once more by a shadow ray that ends before it.
TEST(WideBvh, AsksDoublesAboutWhatIsTinyInTheDistance) {
    Random random(9);
    std::size_t wrong = 0, hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const double size = std::exp2(random.uniform(-23, -15));
        const Vec<float> middle(1, random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
        const auto near_middle = [&] { return middle + hard::random_point(random, size); };
        const hard::Mesh mesh{{near_middle(), near_middle(), near_middle()}};
        const WideBvh<Triangle<>> bvh{std::span<const Triangle<>>(mesh)};
        const Vec<double> target = (Vec<double>(mesh[0].a) + Vec<double>(mesh[0].b) + Vec<double>(mesh[0].c)) / 3.0;
        Ray<double> ray{Vec<double>(0), target};
        const auto expected = closest_hit(ray, Scene(mesh));
        hits += bool(expected);
        wrong += differ(expected, closest_hit(ray, bvh)) || any_hit(ray, bvh) != bool(expected);
        ray.t_max = 0.5;
        wrong += bool(closest_hit(ray, bvh)) || any_hit(ray, bvh);
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(hits, 2000u);
}

// Memory in large pages holds what any memory holds, from the first node to more than a page of them.
TEST(WideBvh, KeepsItsNodesInLargePages) {
    LargeVector<WideNode> nodes;
    for (Id i = 0; i < 20'000; ++i) {
        nodes.emplace_back().links[0] = WideLink::node(i);
        ASSERT_EQ(reinterpret_cast<std::uintptr_t>(nodes.data()) % alignof(WideNode), 0u);
    }
    const LargeVector<WideNode> copy = nodes;
    for (Id i = 0; i < copy.size(); ++i)
        ASSERT_EQ(copy[i].links[0].first(), i);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(copy.data()) % LargePages<WideNode>::page, 0u);
}

// A mesh has about half as many corners as triangles: leaves that keep each once take two thirds of the memory.
TEST(WideBvh, CompactLeavesHoldEveryCornerOnce) {
    const hard::Mesh mesh = hard::hard_meshes()[0].triangles;
    const WideBvhBy<Triangle<>, WideOptions{.leaf = WideOptions::Leaf::compact}> compact{
        std::span<const Triangle<>>(mesh)};
    for (Id id = 0; id < mesh.size(); ++id) {
        const Triangle<> kept = compact.shapes[compact.shapes.slot_of(id)];
        EXPECT_TRUE(kept.a == mesh[id].a && kept.b == mesh[id].b && kept.c == mesh[id].c);
        EXPECT_EQ(compact.shapes.first_id(compact.shapes.slot_of(id)), id);
    }
    for (const CompactLeaf &leaf : compact.shapes.leaves())
        for (const std::uint32_t of_lanes : leaf.of_lanes)
            EXPECT_LT(of_lanes, 1u << 24);
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
                        ++seen[bvh.shapes.first_id(bvh.shapes.first_slot(node.links[i]) + lane)];
        EXPECT_EQ(std::ranges::count(seen, 1), std::ssize(seen));
        return bvh.tree.nodes.size();
    };
    EXPECT_LT(check.operator()<WideOptions{}>(),
              (check.operator()<WideOptions{.collapse = WideOptions::Collapse::greedy}>()));
    check.operator()<WideOptions{.leaf = WideOptions::Leaf::compact}>();
}

} // namespace
