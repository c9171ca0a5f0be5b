// Lesson 13, step 4: who proposes planes, and which of them is taken.
#pragma once
#include "chapters/13_bsp_tree/piece.hpp"
#include "common/random.hpp"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace course {

enum class Planes {
    axis_aligned, // at right angles to an axis: a kd-tree, but for its cells, which are scored as they are
    general,      // these, the planes of the shapes themselves, and planes between two shapes
    supporting    // the plane of any triangle, unseen: the classical auto-partition
};

// A walk has as many places for cells that wait.
inline constexpr int deepest_bsp = 96;

struct BspRule {
    Planes planes = Planes::general;
    std::size_t small_leaf = 2;
    double node_cost = 1;    // looking at a node, in units of a primitive's test
    double most_entries = 8; // so many entries in leaves, at most, for each shape (see chapter 11)
    int deepest = deepest_bsp;
    std::size_t askers = 3;   // shapes that may propose planes, in each node
    std::size_t judges = 128; // shapes that are counted to score a plane
};

// A shape in a cell.
template <Bounded Shape> struct Member {
    Id index;
    Piece<Shape> piece;
    bool has_proposed = false; // auto-partition: its plane has divided a cell around this one
};

// Where a piece is: within means in the plane, to within the margin.
enum Side { behind, in_front, both, within };

template <Bounded Shape> Side side_of(const Piece<Shape> &piece, const SplitPlane &plane, double margin) {
    const auto [low, high] = piece.over(plane);
    if (high <= margin)
        return low >= -margin ? within : behind;
    return low >= -margin ? in_front : both;
}

// How many pieces are on each side, by Side. What lies within the plane goes where fewer are: either is right, since
// the walk looks at both sides of a plane with a margin that is wider.
struct Census {
    std::array<std::size_t, 4> count{};

    bool within_goes_behind() const { return count[behind] <= count[in_front]; }
    std::size_t back() const { return count[behind] + count[both] + (within_goes_behind() ? count[within] : 0); }
    std::size_t front() const { return count[in_front] + count[both] + (within_goes_behind() ? 0 : count[within]); }
};

struct Choice {
    SplitPlane plane{};
    double cost = infinity<double>;
};

// Chooses the best of the planes that it is asked about, for the members of one cell: by the surface area heuristic,
// where cells are no boxes. The ratio of the surfaces is still the share of the lines through the cell that meet the
// part.
template <Bounded Shape> class Judge {
  public:
    Judge(std::span<const Member<Shape>> members, const Polytope &cell, const BspRule &rule, double margin)
        : members_(members), cell_(cell), rule_(rule), margin_(margin), surface_(cell.surface()) {}

    void operator()(const SplitPlane &plane) {
        if (plane.normal == Vec<float>(0))
            return;
        const std::size_t stride = 1 + (members_.size() - 1) / rule_.judges;
        Census census;
        std::size_t counted = 0;
        for (std::size_t i = 0; i < members_.size(); i += stride, ++counted)
            ++census.count[side_of(members_[i].piece, plane, margin_)];
        const double scale = static_cast<double>(members_.size()) / static_cast<double>(counted);
        const double back = scale * static_cast<double>(census.back()),
                     front = scale * static_cast<double>(census.front());
        // The two parts together have at least the cell's surface: a bound that spares most of the cutting of faces.
        if (rule_.node_cost + std::min(back, front) >= best_.cost)
            return;
        const auto [back_surface, front_surface] = surfaces_of_parts(cell_, plane);
        if (std::min(back_surface, front_surface) < 1e-6 * surface_)
            return; // along a border of the cell, the plane divides nothing
        const double cost = rule_.node_cost + (back_surface * back + front_surface * front) / surface_;
        if (cost < best_.cost)
            best_ = {plane, cost};
    }

    void ask_across(int axis, double place) {
        Vec<double> normal(0), point(0);
        normal[axis] = 1;
        point[axis] = place;
        (*this)(plane_across(normal, point));
    }

    const Choice &best() const { return best_; }

  private:
    std::span<const Member<Shape>> members_;
    const Polytope &cell_;
    const BspRule &rule_;
    double margin_, surface_;
    Choice best_;
};

template <Bounded Shape> Choice best_plane(std::span<const Shape> shapes, std::span<const Member<Shape>> members,
                                           const Polytope &cell, const BspRule &rule, double margin, Random random) {
    Judge<Shape> judge(members, cell, rule, margin);
    Box<double> box = empty_box<double>();
    for (const Member<Shape> &member : members)
        box = merge(box, member.piece.box());
    const int steps = members.size() > 16 ? 8 : 1;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i <= steps; ++i) // the ends too: to cut off empty space is often the best of cuts
            judge.ask_across(axis, box.lo[axis] + static_cast<double>(i) / steps * (box.hi[axis] - box.lo[axis]));
    const auto anyone = [&]() -> const Member<Shape> & { return members[random.bits() % members.size()]; };
    for (std::size_t i = 0; i < rule.askers; ++i) {
        const Member<Shape> &member = anyone();
        const Box<double> own = member.piece.box();
        for (int axis = 0; axis < 3; ++axis) {
            judge.ask_across(axis, own.lo[axis]);
            judge.ask_across(axis, own.hi[axis]);
        }
        if (rule.planes == Planes::axis_aligned)
            continue;
        Piece<Shape>::each_own_plane(shapes[member.index], judge);
        const Vec<double> here = centre(own), there = centre(anyone().piece.box());
        judge(plane_across(there - here, 0.5 * (here + there)));
    }
    return judge.best();
}

// Auto-partition: the own plane of a member that has not proposed yet; without any, no choice.
template <Bounded Shape>
Choice any_own_plane(std::span<const Shape> shapes, std::span<Member<Shape>> members, Random random) {
    Choice choice;
    const std::size_t start = random.bits() % members.size();
    for (std::size_t i = 0; i < members.size() && choice.cost > 0; ++i) {
        Member<Shape> &member = members[(start + i) % members.size()];
        if (std::exchange(member.has_proposed, true))
            continue;
        Piece<Shape>::each_own_plane(shapes[member.index], [&](const SplitPlane &plane) {
            if (choice.cost > 0 && plane.normal != Vec<float>(0))
                choice = {plane, 0};
        });
    }
    return choice;
}

} // namespace course
