// Lesson 11, step 2: dividing space where something is, and no further than it pays.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/10_uniform_grid/overlap.hpp"
#include "chapters/11_octree/node.hpp"

#include <array>
#include <utility>

namespace course {

// Replaces the indices of `entries`, all below `size`, by slots: 0 for the index that comes first, 1 for the next other
// one, and so on, so that neighbours in space are neighbours in memory. Returns the index of each slot.
inline std::vector<Id> number_by_appearance(std::vector<Id> &entries, std::size_t size) {
    std::vector<Id> order, slots(size, no_id);
    for (Id &entry : entries) {
        if (slots[entry] == no_id) {
            slots[entry] = static_cast<Id>(order.size());
            order.push_back(entry);
        }
        entry = slots[entry];
    }
    return order;
}

struct OctreeRule {
    std::size_t small_leaf = 2; // so few shapes are not worth a question
    double node_cost = 1;       // looking at a node, in units of a primitive's test
    double most_entries = 16;   // so many entries in leaves, at most, for each shape
    int deepest = 24;           // at most 31
    bool exact = true;          // ask the shape itself whether it reaches into a cell, not only its box

    // A line that enters a cube enters each of its octants with the probability 1/4, the ratio of their surfaces: on
    // average two of the eight. So a division with `entries` in all octants together costs a visit and a quarter of
    // these tests, in place of `shapes` tests.
    bool pays(std::size_t shapes, std::size_t entries) const {
        return node_cost + 0.25 * static_cast<double>(entries) < static_cast<double>(shapes);
    }
};

struct Octants {
    Cube cube;
    std::vector<OctreeNode> nodes; // the root first; none at all around nothing
    std::vector<Id> entries;       // of the leaves, one after the other
};

template <Bounded Shape> class OctreeBuilder {
  public:
    // The shapes and their boxes, by index.
    OctreeBuilder(std::span<const Shape> shapes, std::span<const Box<float>> boxes, const OctreeRule &rule)
        : shapes_(shapes), boxes_(boxes), rule_(rule) {
        rule_.deepest = std::min(rule_.deepest, 31);
    }

    // Around the shapes with the indices `members`; the entries are indices too.
    Octants build(std::vector<Id> members, const Box<float> &around);

  private:
    using Parts = std::array<std::vector<Id>, 8>;

    // `room` is by what factor the entries below this node may still grow. A division by which they grow k-fold leaves
    // each child room / k, so the sum of entries times room stays the same all the way down. No leaf has room < 1, so
    // all leaves together hold at most most_entries for each shape. Without that, a bundle of long needles in one place
    // would double its entries with each level.
    void divide(std::size_t node, const Cube &cube, std::vector<Id> members, double room, int depth) {
        if (members.size() > rule_.small_leaf && depth < rule_.deepest && cube.edge > smallest_) {
            Parts parts = parts_of(cube, members);
            std::size_t entries = 0;
            unsigned octants = 0;
            for (unsigned octant = 0; octant < 8; ++octant) {
                entries += parts[octant].size();
                octants |= parts[octant].empty() ? 0 : 1u << octant;
            }
            const double growth = static_cast<double>(entries) / static_cast<double>(members.size());
            if (rule_.pays(members.size(), entries) && growth <= room) {
                members = {};
                const OctreeNode made = OctreeNode::inner(tree_.nodes.size(), octants);
                tree_.nodes[node] = made;
                tree_.nodes.resize(tree_.nodes.size() + static_cast<std::size_t>(std::popcount(octants)));
                for (unsigned octant = 0; octant < 8; ++octant)
                    if (!parts[octant].empty())
                        divide(made.child(octant), cube.octant(octant), std::move(parts[octant]), room / growth,
                               depth + 1);
                return;
            }
        }
        tree_.nodes[node] = OctreeNode::leaf(tree_.entries.size(), members.size());
        tree_.entries.insert(tree_.entries.end(), members.begin(), members.end());
    }

    // Who reaches into which octant. Most shapes lie in one alone, as their boxes say; the others are asked.
    Parts parts_of(const Cube &cube, std::span<const Id> members) const {
        Parts parts;
        std::array<Box<double>, 8> cells;
        for (unsigned octant = 0; octant < 8; ++octant)
            cells[octant] = cube.octant(octant).box(rim_);
        for (const Id index : members) {
            const unsigned candidates = octants_met(boxes_[index], cells[0].hi, cells[7].lo);
            if (!rule_.exact || std::has_single_bit(candidates)) {
                for (unsigned rest = candidates; rest; rest &= rest - 1)
                    parts[static_cast<unsigned>(std::countr_zero(rest))].push_back(index);
                continue;
            }
            const Overlap<Shape> overlap(shapes_[index]);
            for (unsigned rest = candidates; rest; rest &= rest - 1) {
                const auto octant = static_cast<unsigned>(std::countr_zero(rest));
                if (overlap(cells[octant]))
                    parts[octant].push_back(index);
            }
        }
        return parts;
    }

    // The octants that a box reaches into, where the lower ones end at low_end and the upper ones begin at high_begin.
    static unsigned octants_met(const Box<float> &box, const Vec<double> &low_end, const Vec<double> &high_begin) {
        constexpr std::array<unsigned, 3> upper{0b10101010, 0b11001100, 0b11110000};
        unsigned met = 0b11111111;
        for (int axis = 0; axis < 3; ++axis) {
            const unsigned high = upper[static_cast<std::size_t>(axis)];
            met &= (static_cast<double>(box.lo[axis]) <= low_end[axis] ? 0xff & ~high : 0) |
                   (static_cast<double>(box.hi[axis]) >= high_begin[axis] ? high : 0);
        }
        return met;
    }

    std::span<const Shape> shapes_;
    std::span<const Box<float>> boxes_;
    OctreeRule rule_;
    double rim_ = 0, smallest_ = 0;
    Octants tree_;
};

template <Bounded Shape> Octants OctreeBuilder<Shape>::build(std::vector<Id> members, const Box<float> &around) {
    if (members.empty())
        return {};
    tree_.cube = cube_around(around);
    rim_ = rim_around(around);
    // A walk looks at cells with a margin of 2^-24 of the coordinates: smaller cells would save it nothing.
    smallest_ = 0x1p-20 * largest_coordinate(around);
    tree_.nodes.resize(1);
    divide(0, tree_.cube, std::move(members), rule_.most_entries, 0);
    tree_.nodes.shrink_to_fit();
    tree_.entries.shrink_to_fit();
    return std::move(tree_);
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template class OctreeBuilder<Triangle<>>;
#endif

} // namespace course
