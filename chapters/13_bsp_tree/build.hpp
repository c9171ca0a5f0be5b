// Lesson 13, step 5: building the tree.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/13_bsp_tree/choose.hpp"
#include "chapters/13_bsp_tree/node.hpp"

namespace course {

struct BspPlanes {
    std::vector<BspNode> nodes;
    std::vector<Id> entries; // of the leaves, one after the other
    int depth = 0;           // of the deepest leaf
};

template <Bounded Shape> class BspBuilder {
  public:
    BspBuilder(std::span<const Shape> shapes, const BspRule &rule) : shapes_(shapes), rule_(rule) {}

    // Around the shapes with these indices, and boxes by index; the entries are indices too.
    BspPlanes build(std::span<const Box<float>> boxes, std::span<const Id> indices, const Box<float> &around);

  private:
    using Members = std::vector<Member<Shape>>;

    void divide(Members members, const Polytope &cell, double room, int depth) {
        tree_.depth = std::max(tree_.depth, depth);
        const std::size_t node = tree_.nodes.size();
        const auto count = static_cast<double>(members.size());
        tree_.nodes.emplace_back();
        if (members.size() > rule_.small_leaf && depth < rule_.deepest) {
            const Choice choice = chosen(members, cell);
            if (choice.cost < count) {
                const Census census = counted(members, choice.plane);
                const double growth = static_cast<double>(census.back() + census.front()) / count;
                if (growth <= room) {
                    auto [back, front] = halves(std::move(members), choice.plane, census);
                    divide(std::move(back), cell_part(cell, choice.plane, -1), room / growth, depth + 1);
                    tree_.nodes[node] = BspNode::inner(choice.plane, tree_.nodes.size());
                    divide(std::move(front), cell_part(cell, choice.plane, 1), room / growth, depth + 1);
                    return;
                }
            }
        }
        tree_.nodes[node] = BspNode::leaf(tree_.entries.size(), members.size());
        for (const Member<Shape> &member : members)
            tree_.entries.push_back(member.index);
    }

    Choice chosen(Members &members, const Polytope &cell) const {
        const Random random(tree_.nodes.size());
        if (rule_.planes == Planes::supporting)
            return any_own_plane(shapes_, std::span(members), random);
        return best_plane(shapes_, std::span<const Member<Shape>>(members), cell, rule_, margin_, random);
    }

    // Only who scores planes needs to know the cell.
    Polytope cell_part(const Polytope &cell, const SplitPlane &plane, int side) const {
        return rule_.planes == Planes::supporting ? Polytope{} : part_of(cell, plane, side);
    }

    Census counted(const Members &members, const SplitPlane &plane) const {
        Census census;
        for (const Member<Shape> &member : members)
            ++census.count[side_of(member.piece, plane, margin_)];
        return census;
    }

    // A piece on both sides is cut, so that further planes see only what of the shape is in their cell.
    std::pair<Members, Members> halves(Members members, const SplitPlane &plane, const Census &census) const {
        std::pair<Members, Members> result;
        result.first.reserve(census.back());
        result.second.reserve(census.front());
        for (Member<Shape> &member : members) {
            const auto &[index, piece, has_proposed] = member;
            const Side side = side_of(piece, plane, margin_);
            if (side == both) {
                result.first.push_back({index, piece.part(plane, -1), has_proposed});
                result.second.push_back({index, piece.part(plane, 1), has_proposed});
            } else if (side == behind || (side == within && census.within_goes_behind()))
                result.first.push_back(std::move(member));
            else
                result.second.push_back(std::move(member));
        }
        return result;
    }

    std::span<const Shape> shapes_;
    BspRule rule_;
    double margin_ = 0;
    BspPlanes tree_;
};

template <Bounded Shape> BspPlanes BspBuilder<Shape>::build(std::span<const Box<float>> boxes,
                                                            std::span<const Id> indices, const Box<float> &around) {
    if (indices.empty())
        return {};
    margin_ = std::max(0x1p-26 * largest_coordinate(around), 0x1p-130);
    Members members;
    members.reserve(indices.size());
    for (const Id index : indices)
        members.push_back({index, Piece<Shape>(shapes_[index], boxes[index])});
    const Box<double> wide{Vec<double>(around.lo) - margin_, Vec<double>(around.hi) + margin_};
    divide(std::move(members), polytope_of(wide), rule_.most_entries, 0);
    tree_.nodes.shrink_to_fit();
    tree_.entries.shrink_to_fit();
    return std::move(tree_);
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template class BspBuilder<Triangle<>>;
#endif

} // namespace course
