// Whatever structure finds the hits, the picture is the same; and the tree keeps what it promises.
#include "chapters/08_mesh/ball.hpp"
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/14_bvh/shown.hpp"
#include "chapters/14_bvh/taught.hpp"
#include "common/parallel.hpp"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

using namespace course;

namespace {

TEST(Pictures, AreTheSameWithEveryStructure) {
    const Studio studio = course::studio(ball(3));
    Picture first;
    for (const std::string &name : names_of(structures_of_14))
        with_shown(name, studio, 1, [&](const Shown &shown) {
            Picture picture(64, 48);
            shown.lit(studio.view, 64, 48)({0, 0, 64, 48}, picture);
            if (first.pixels.empty())
                first = picture;
            EXPECT_EQ(std::memcmp(picture.pixels.data(), first.pixels.data(), first.pixels.size() * sizeof(Colour)), 0)
                << name;
        });
    const auto [darkest, brightest] =
        std::ranges::minmax(first.pixels, {}, [](const Colour &colour) { return colour.g; });
    EXPECT_GT(brightest.g, 2 * darkest.g); // there is something to see
}

// Every primitive is in one leaf, once; and every box holds what is below it.
Box<float> check(const BvhBy<Triangle<>, BinnedSah> &bvh, Link at, std::vector<int> &seen) {
    Box<float> around = empty_box();
    if (at.is_leaf()) {
        for (Id slot = at.first; slot < at.first + at.count; ++slot) {
            ++seen[slot];
            around = merge(around, bounds(bvh.shapes[slot]));
        }
        return around;
    }
    const Node &node = bvh.tree.nodes[at.first];
    for (int child = 0; child < 2; ++child) {
        const Box<float> below = check(bvh, node.children[child], seen);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(node.planes[axis][0][child], below.lo[axis]);
            EXPECT_EQ(node.planes[axis][1][child], below.hi[axis]);
        }
        around = merge(around, below);
    }
    return around;
}

TEST(Bvh, HoldsEveryTriangleOnceInTightBoxes) {
    const auto all = triangles(ball(5));
    const Bvh<Triangle<>> bvh{std::span<const Triangle<>>(all)};
    std::vector<int> seen(all.size(), 0);
    const Box<float> whole = check(bvh, bvh.tree.root, seen);
    EXPECT_EQ(whole.lo, bvh.box.lo);
    EXPECT_EQ(std::ranges::count(seen, 1), static_cast<std::ptrdiff_t>(all.size()));
    EXPECT_LE(bytes(bvh), 110 * all.size());
}

TEST(Bvh, IsTheSameOnAnyNumberOfThreads) {
    const auto all = triangles(ball(6)); // large enough to be built in parallel
    use_threads(1);
    const Bvh<Triangle<>> alone{std::span<const Triangle<>>(all)};
    use_threads(4);
    const Bvh<Triangle<>> together{std::span<const Triangle<>>(all)};
    use_threads(0);
    ASSERT_EQ(alone.tree.nodes.size(), together.tree.nodes.size());
    EXPECT_EQ(std::memcmp(alone.tree.nodes.data(), together.tree.nodes.data(), alone.node_bytes()), 0);
}

// Every next triangle is half as far away: as uneven as floats can be.
std::vector<Triangle<>> ever_farther() {
    std::vector<Triangle<>> all;
    for (int i = 0; i < 240; ++i) {
        const float x = std::ldexp(1.0f, i - 120), y = x / 4;
        all.push_back({{x, 0, 0}, {x + y, 0, y}, {x, y, 0}});
    }
    return all;
}

// The depth of the deepest leaf, and the most that a leaf holds.
std::pair<int, Id> depth_and_largest_leaf(const Tree &tree, Link at) {
    if (at.is_leaf())
        return {0, at.count};
    const Node &node = tree.nodes[at.first];
    const auto [a_depth, a_count] = depth_and_largest_leaf(tree, node.children[0]);
    const auto [b_depth, b_count] = depth_and_largest_leaf(tree, node.children[1]);
    return {1 + std::max(a_depth, b_depth), std::max(a_count, b_count)};
}

TEST(Bvh, FindsWhatIsNearAmongWhatIsFar) {
    const Bvh<Triangle<>> bvh{std::span<const Triangle<>>(ever_farther())};
    const int depth = depth_and_largest_leaf(bvh.tree, bvh.tree.root).first;
    EXPECT_LE(depth, deepest);
    EXPECT_GT(depth, 20);
    EXPECT_TRUE(closest_hit(Ray<double>{{1.1, 0.05, -1}, {0, 0, 1}}, bvh));
}

// A rule that always splits off one.
struct OneByOne {
    std::size_t largest_leaf;
    std::size_t operator()(std::span<Item> items, const Box4 &) const { return items.size() > largest_leaf; }
};

// The tree must not become deeper than a walk's stack, nor a leaf larger than the rule allows.
TEST(Bvh, StaysShallowWithSmallLeavesWhateverItsRule) {
    const std::vector<Triangle<>> all = ever_farther();
    const auto boxes = float_boxes(std::span<const Triangle<>>(all));
    for (const std::size_t largest : {1u, 2u, 4u, 8u}) {
        const Tree tree = TreeBuilder(boxes, can_be_hit(boxes), OneByOne{largest}).build();
        const auto [depth, count] = depth_and_largest_leaf(tree, tree.root);
        EXPECT_GT(depth, deepest - 32); // the rule alone would go on
        EXPECT_LE(depth, deepest);
        EXPECT_LE(count, largest);
    }
}

} // namespace
