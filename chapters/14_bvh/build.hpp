// Lesson 14, step 4: building the tree, on every core.
#pragma once
#include "chapters/14_bvh/node.hpp"
#include "chapters/14_bvh/rules.hpp"
#include "common/parallel.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace course {

struct Tree {
    Link root{};
    Box<float> box = empty_box();
    std::vector<Node> nodes;
    std::vector<Id> order; // the primitives as the leaves hold them
};

// No leaf lies deeper, so a traversal never has more children waiting.
inline constexpr int deepest = 96;

template <class Rule> class TreeBuilder {
  public:
    TreeBuilder(std::span<const Box<float>> boxes, std::span<const Id> ids, const Rule &rule) : rule_(rule) {
        items_.reserve(ids.size());
        for (const Id id : ids)
            items_.push_back({{four(boxes[id].lo), four(boxes[id].hi)}, id});
        nodes_.resize(items_.empty() ? 0 : items_.size() - 1);
    }

    Tree build();

  private:
    // The tree over `count` items from `first` on. It needs count - 1 nodes at most and has those from number `node` on
    // to itself: one for the cut, then left - 1 for one half, then the rest for the other. So two cores can build the
    // halves without asking each other, and the tree is the same on any number of cores.
    Link subtree(std::size_t first, std::size_t count, std::size_t node, const Box4 &box, int depth) {
        const std::span<Item> items = std::span(items_).subspan(first, count);
        const bool is_deep = depth >= deepest - 32; // whatever the rule makes of this scene: halving ends in 32 steps
        const std::size_t left = is_deep ? LongestAxisMedian{rule_.largest_leaf}(items, box) : rule_(items, box);
        if (left == 0)
            return {static_cast<Id>(first), static_cast<Id>(count)};
        const auto build_child = [&](std::size_t i) {
            const std::size_t from = i == 0 ? 0 : left, size = i == 0 ? left : count - left;
            const Box4 own = box_of(items.subspan(from, size));
            nodes_[node].set(i, own.lo, own.hi,
                             subtree(first + from, size, node + (i == 0 ? 1 : left), own, depth + 1));
        };
        if (count > 8192) {
            parallel_for(2, build_child);
        } else {
            build_child(0);
            build_child(1);
        }
        return {static_cast<Id>(node), 0};
    }

    static Four four(const Vec<float> &v) { return Four{v.x, v.y, v.z, 0}; }

    // Copies the nodes that were needed, each before its children, and the first child right behind it.
    Link gather(Link link, std::vector<Node> &into) const {
        if (link.is_leaf())
            return link;
        const std::size_t at = into.size();
        into.push_back(nodes_[link.first]);
        for (const int child : {0, 1}) {
            const Link moved = gather(into[at].children[child], into);
            into[at].children[child] = moved;
        }
        return {static_cast<Id>(at), 0};
    }

    Rule rule_;
    std::vector<Item> items_;
    std::vector<Node> nodes_;
};

template <class Rule> Tree TreeBuilder<Rule>::build() {
    Tree tree;
    if (items_.empty())
        return tree;
    const Box4 box = box_of(items_);
    tree.box = {{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}};
    tree.root = gather(subtree(0, items_.size(), 0, box, 0), tree.nodes);
    for (const Item &item : items_)
        tree.order.push_back(item.id);
    return tree;
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template class TreeBuilder<BinnedSah>;
extern template class TreeBuilder<LongestAxisMedian>;
#endif

} // namespace course
