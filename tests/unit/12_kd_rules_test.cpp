// The parts of the kd-tree: the node, the rules, the sides of a plane, the builder.
#include "chapters/10_uniform_grid/scenes.hpp"
#include "chapters/12_kd_tree/kd_tree.hpp"

#include <gtest/gtest.h>

namespace {

using namespace course;

std::span<const Triangle<>> span_of(const std::vector<Triangle<>> &list) { return list; }

TEST(KdNode, KeepsWhatItIsGiven) {
    for (const int axis : {0, 1, 2})
        for (const float at : {-1.5f, 0.0f, -0.0f, 1e-40f, 3e38f}) {
            const KdNode cut = KdNode::cut(axis, at, 123456789);
            EXPECT_FALSE(cut.is_leaf());
            EXPECT_EQ(cut.axis(), axis);
            EXPECT_EQ(std::bit_cast<std::uint32_t>(cut.at()), std::bit_cast<std::uint32_t>(at));
            EXPECT_EQ(cut.upper(), 123456789u);
        }
    const KdNode leaf = KdNode::leaf(4000000000u, 1000000000u);
    EXPECT_TRUE(leaf.is_leaf());
    EXPECT_EQ(leaf.first(), 4000000000u);
    EXPECT_EQ(leaf.count(), 1000000000u);
    EXPECT_TRUE(KdNode::box().is_box());
    EXPECT_FALSE(KdNode::box().is_leaf());
    EXPECT_FALSE(KdNode::box().is_cut());
    EXPECT_EQ(KdNode::sides(-0.0f, 3e38f).side(true), 3e38f);
    EXPECT_TRUE(std::signbit(KdNode::sides(-0.0f, 3e38f).side(false)));
}

TEST(KdCut, EveryBoxGoesToASideAndTouchingIsNotOverlapping) {
    const auto sides = [](float lo, float hi) {
        const Box<float> box{{lo, 0, 0}, {hi, 1, 1}};
        return goes_below(box, {0, 2}) + 2 * goes_above(box, {0, 2});
    };
    EXPECT_EQ(sides(0, 1), 1);
    EXPECT_EQ(sides(0, 2), 1);
    EXPECT_EQ(sides(2, 2), 1);
    EXPECT_EQ(sides(2, 3), 2);
    EXPECT_EQ(sides(1, 3), 3);
}

// The rule against the definition: the leaf, the box, and every plane through a side of a box, its cost by counting.
TEST(LeastCost, FindsTheCheapestOfAllPlanes) {
    Random random(1);
    const LeastCost rule;
    const Box<float> cell{{0, 0, 0}, {2, 3, 4}};
    int cuts = 0, boxes = 0;
    for (int i = 0; i < 300; ++i) {
        std::vector<KdItem> items;
        for (Id id = 0; id < 1 + random.bits() % 40; ++id) {
            const Vec<float> at(random.uniform(0, 2), random.uniform(0, 3), random.uniform(0, 4));
            Box<float> box{at, min(at + static_cast<float>(random.uniform(0, 0.5)), cell.hi)};
            if (i % 2) // half of them flat, in one of two planes of an axis
                if (const int axis = static_cast<int>(random.bits() % 6); axis < 3)
                    box.lo[axis] = box.hi[axis] = random.bits() % 2 ? 1.5f : 1.75f;
            items.push_back({box, id});
        }
        const auto cost = [&](const KdCut &cut) {
            const double all = static_cast<double>(rule.test_cost) * static_cast<double>(items.size());
            if (cut.axis == KdCut::leaf)
                return all;
            if (cut.axis == KdCut::box)
                return static_cast<double>(rule.box_cost) + all * surface_area(box_of(items)) / surface_area(cell);
            Box<float> low = cell, high = cell;
            low.hi[cut.axis] = high.lo[cut.axis] = cut.at;
            double below = 0, above = 0;
            for (const KdItem &item : items) {
                below += goes_below(item.box, cut);
                above += goes_above(item.box, cut);
            }
            if (below == 0 || above == 0) // air is left to the box
                return infinity<double>;
            return 1 + static_cast<double>(rule.test_cost) * (surface_area(low) * below + surface_area(high) * above) /
                           surface_area(cell);
        };
        double least = std::min(cost({}), cost({KdCut::box}));
        for (int axis = 0; axis < 3; ++axis)
            for (const KdItem &item : items)
                for (const float at : {item.box.lo[axis], item.box.hi[axis]})
                    if (at > cell.lo[axis] && at < cell.hi[axis])
                        least = std::min(least, cost({axis, at}));
        const KdCut cut = rule(items, cell, 0);
        cuts += cut.axis < 3;
        boxes += cut.axis == KdCut::box;
        EXPECT_NEAR(cost(cut), least, 1e-4 * least);
    }
    EXPECT_GT(cuts, 150);
    EXPECT_GT(boxes, 10);
}

// More items than are tried exactly: a crowd that ends at a wall, and a smaller one behind a gap. The wall is where
// none of the evenly spaced planes is.
TEST(LeastCost, CutsFlushWithAWall) {
    Random random(1);
    std::vector<KdItem> items;
    for (Id id = 0; id < 200; ++id) {
        const Vec<float> at(id % 4 > 0 ? 0 : 0.7f, random.uniform(0, 0.9), random.uniform(0, 0.9));
        items.push_back({{at, at + Vec<float>(0.3f, 0.1f, 0.1f)}, id});
    }
    const KdCut cut = LeastCost{}(items, {{0, 0, 0}, {1, 1, 1}}, 0);
    EXPECT_EQ(cut.axis, 0);
    EXPECT_EQ(cut.at, 0.3f);
}

// Many in one plane, whom a cut there puts below, to those from whom it should part them: so it is no good cut. With a
// few items the next best side is that of the crowd at the other end, with many the border of bins before the plane.
TEST(LeastCost, CountsWhatLiesInThePlane) {
    for (const Id times : {1u, 20u}) {
        std::vector<KdItem> items;
        for (Id id = 0; id < 51 * times; ++id)
            items.push_back({id % 51 < 10   ? Box<float>{{0, 0, 0}, {0.5f, 1, 1}}
                             : id % 51 < 50 ? Box<float>{{9, 0, 0}, {9, 1, 1}}
                                            : Box<float>{{9.5f, 0, 0}, {10, 1, 1}},
                             id});
        const KdCut cut = LeastCost{}(items, {{0, 0, 0}, {10, 1, 1}}, 0);
        EXPECT_EQ(cut.axis, 0);
        EXPECT_EQ(cut.at, times == 1 ? 0.5f : 10 * 57 / 64.0f);
    }
}

TEST(LeastCost, LeavesTheAirOutAndKnowsWhenToStop) {
    const Box<float> cell{{0, 0, 0}, {10, 10, 10}};
    std::vector<KdItem> crowd;
    for (Id id = 0; id < 200; ++id)
        crowd.push_back({{{0, 0, 0}, {1, 1, 1}}, id});
    EXPECT_EQ(LeastCost{}(crowd, cell, 0).axis, KdCut::box);
    EXPECT_EQ(LeastCost{}(crowd, {{0, 0, 0}, {1, 1, 1}}, 0).axis, KdCut::leaf) << "nothing tells these boxes apart";
    EXPECT_EQ(LeastCost{}(std::span(crowd).first(1), cell, 0).axis, KdCut::leaf) << "a test is cheaper than a box";
}

// Every point of a triangle lies in a leaf that lists it, whatever the rule; and the tree has no more than it needs.
template <class Tree> class KdTree : public ::testing::Test {};
using Trees = ::testing::Types<KdTreeMiddle<Triangle<>>, KdTreeMedian<Triangle<>>, KdTreeSah<Triangle<>>>;
TYPED_TEST_SUITE(KdTree, Trees);

TYPED_TEST(KdTree, ListsATriangleWhereverItIs) {
    Random random(2);
    auto list = soup(400, 3);
    for (std::size_t i = 0; i < list.size(); i += 3) // many in planes where cuts are likely
        list[i].a.x = list[i].b.x = list[i].c.x = 0.25f;
    const TypeParam tree(span_of(list));
    int missing = 0;
    for (Id slot = 0; slot < tree.shapes.slots(); ++slot)
        for (int i = 0; i < 100; ++i) {
            const auto &[a, b, c] = tree.shapes[slot];
            const double u = random.uniform(), v = random.uniform(0, 1 - u);
            const Vec<double> point = Vec<double>(a) + u * Vec<double>(b - a) + v * Vec<double>(c - a);
            bool listed = false;
            const auto look = [&](auto self, std::uint32_t at) -> void {
                const KdNode node = tree.nodes[at];
                if (node.is_leaf()) {
                    for (std::uint32_t j = node.first(); j < node.first() + node.count(); ++j)
                        listed |= tree.lists[j] == slot;
                    return;
                }
                if (node.is_box()) {
                    bool within = true;
                    for (int axis = 0; axis < 3; ++axis) {
                        const KdNode sides = tree.nodes[at + 1 + static_cast<std::uint32_t>(axis)];
                        within &= point[axis] >= static_cast<double>(sides.side(false)) - 1e-7 &&
                                  point[axis] <= static_cast<double>(sides.side(true)) + 1e-7;
                    }
                    if (within)
                        self(self, at + KdNode::box_size);
                    return;
                }
                const double off = point[node.axis()] - static_cast<double>(node.at());
                if (off <= 1e-7) // the point itself is rounded
                    self(self, at + 1);
                if (off >= -1e-7)
                    self(self, node.upper());
            };
            look(look, 0);
            missing += !listed;
        }
    EXPECT_EQ(missing, 0);
    EXPECT_EQ(tree.shapes.slots(), list.size());
    EXPECT_LT(tree.lists.size(), 40 * list.size());
}

// Around a plane the ray is on both sides, away from it on one.
TEST(SplitRay, GivesBothSidesRoom) {
    const Box<float> reach{{-1, -1, -1}, {1, 1, 1}};
    const SplitRay up(Ray<double>{{0, 0, 0}, {2, 0, 0}}, reach), down(Ray<double>{{0, 0, 0}, {-2, 0, 0}}, reach);
    const auto a = up(0, 0.5), b = down(0, -0.5), level = up(1, 0.5), in_plane = up(1, 0);
    EXPECT_FALSE(a.from_above);
    EXPECT_TRUE(b.from_above);
    for (const auto &crossing : {a, b}) {
        EXPECT_LT(crossing.far_begins, 0.25);
        EXPECT_GT(crossing.near_ends, 0.25);
        EXPECT_NEAR(crossing.far_begins, 0.25, 1e-6);
        EXPECT_NEAR(crossing.near_ends, 0.25, 1e-6);
    }
    EXPECT_GT(level.far_begins, 1e6) << "runs beside the plane and never reaches it";
    EXPECT_LT(in_plane.far_begins, 0);
    EXPECT_GT(in_plane.near_ends, 10) << "runs in the plane: both sides, all the way";
}

// A box is entered a margin early and left a margin late, and only the part of the span that was given counts.
TEST(SplitRay, GivesABoxRoom) {
    const Box<float> reach{{-1, -1, -1}, {1, 1, 1}};
    const std::vector<KdNode> sides{KdNode::sides(0.25f, 0.5f), KdNode::sides(-1, 1), KdNode::sides(0, 0)};
    for (const double forwards : {1, -1}) {
        const SplitRay ray(Ray<double>{{forwards > 0 ? 0 : 0.75, 0, 0}, {forwards, 0, 0}}, reach);
        const Span all = ray.within(sides.data(), {0, 10}), rest = ray.within(sides.data(), {0.3, 0.4});
        EXPECT_LT(all.enter, 0.25);
        EXPECT_GT(all.exit, 0.5);
        EXPECT_NEAR(all.enter, 0.25, 1e-6);
        EXPECT_NEAR(all.exit, 0.5, 1e-6);
        EXPECT_EQ(rest.enter, 0.3);
        EXPECT_EQ(rest.exit, 0.4);
    }
    const SplitRay beside(Ray<double>{{0, 0, 0.001}, {1, 0, 0}}, reach);
    const Span none = beside.within(sides.data(), {0, 10});
    EXPECT_GT(none.enter, none.exit);
}

} // namespace
