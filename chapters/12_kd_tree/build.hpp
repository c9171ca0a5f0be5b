// Lesson 12, step 4: cutting cells until the rule says stop.
#pragma once
#include "chapters/10_uniform_grid/overlap.hpp"
#include "chapters/12_kd_tree/node.hpp"
#include "chapters/12_kd_tree/rules.hpp"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace course {

template <Bounded Shape, class Rule> class KdBuilder {
  public:
    std::vector<KdNode> nodes;
    std::vector<Id> lists; // the shapes in the leaves, leaf by leaf
    Box<float> box = empty_box();

    KdBuilder(std::span<const Shape> shapes, std::span<const Box<float>> boxes, std::span<const Id> ids,
              const Rule &rule);

  private:
    // `futile` counts the cuts on the way down that spared neither side any item.
    void subtree(std::vector<KdItem> &items, const Box<float> &cell, int depth, int futile) {
        const bool may_cut = depth < depth_limit_ && futile < 3 && lists.size() < most_entries_;
        const KdCut cut = may_cut ? rule_(items, cell, depth) : KdCut{};
        if (cut.axis == KdCut::leaf)
            return leaf(items);
        if (cut.axis == KdCut::box)
            return within_box(items, box_of(items), depth, futile);
        Box<float> below = cell, above = cell;
        below.hi[cut.axis] = above.lo[cut.axis] = cut.at;
        std::vector<KdItem> low, high;
        for (const KdItem &item : items) {
            const bool low_side = goes_below(item.box, cut), high_side = goes_above(item.box, cut);
            const bool both = low_side && high_side;
            if (low_side && (!both || reaches_into(item, below)))
                low.push_back({common_part(item.box, below), item.id});
            if (high_side && (!both || reaches_into(item, above)))
                high.push_back({common_part(item.box, above), item.id});
        }
        futile = low.size() == items.size() && high.size() == items.size() ? futile + 1 : 0;
        items = {}; // not needed any more while the subtrees are built

        const std::size_t own = nodes.size();
        nodes.push_back(KdNode::leaf(0, 0)); // its place; the lower child comes right behind it
        subtree(low, below, depth + 1, futile);
        const std::size_t upper = nodes.size();
        if (upper >= std::size_t{1} << 30)
            throw std::length_error("more nodes than a kd-tree can number");
        nodes[own] = KdNode::cut(cut.axis, cut.at, static_cast<std::uint32_t>(upper));
        subtree(high, above, depth + 1, futile);
    }

    // A box around what is in a cell is the cell for all that comes below. No depth is counted: a walk leaves nothing
    // waiting there.
    void within_box(std::vector<KdItem> &items, const Box<float> &cell, int depth, int futile) {
        nodes.push_back(KdNode::box());
        for (int axis = 0; axis < 3; ++axis)
            nodes.push_back(KdNode::sides(cell.lo[axis], cell.hi[axis]));
        subtree(items, cell, depth, futile);
    }

    // Of a shape whose box was cut in two, the shape itself may lie in one part only. The margin covers rounding.
    bool reaches_into(const KdItem &item, const Box<float> &cell) const {
        const Overlap<Shape> overlap(shapes_[item.id]);
        return overlap({Vec<double>(cell.lo) - margin_, Vec<double>(cell.hi) + margin_});
    }

    void leaf(const std::vector<KdItem> &items) {
        if (lists.size() + items.size() > ~std::uint32_t{0})
            throw std::length_error("more entries than a kd-tree can number");
        nodes.push_back(
            KdNode::leaf(static_cast<std::uint32_t>(lists.size()), static_cast<std::uint32_t>(items.size())));
        for (const KdItem &item : items)
            lists.push_back(item.id);
    }

    std::span<const Shape> shapes_;
    Rule rule_;
    int depth_limit_ = 0;
    std::size_t most_entries_ = 0;
    double margin_ = 0;
};

template <Bounded Shape, class Rule>
KdBuilder<Shape, Rule>::KdBuilder(std::span<const Shape> shapes, std::span<const Box<float>> boxes,
                                  std::span<const Id> ids, const Rule &rule)
    : shapes_(shapes), rule_(rule) {
    std::vector<KdItem> items;
    for (const Id id : ids) {
        box = merge(box, boxes[id]);
        items.push_back({boxes[id], id});
    }
    depth_limit_ = Rule::depth_limit(items.size());
    most_entries_ = 64 * items.size() + (std::size_t{1} << 22); // lest many large shapes fill the memory
    margin_ = 0x1p-40 * largest_coordinate(box);
    within_box(items, box, 0, 0);
}

} // namespace course
