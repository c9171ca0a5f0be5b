// Lesson 15, step 3: the pieces of chapter 14's binary tree, of which the wide one is made.
#pragma once
#include "chapters/14_bvh/build.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace course {

// A leaf of the binary tree, or all below a node.
struct WidePiece {
    Link link;
    float area; // of half the surface
    const Node *parent = nullptr;
    std::size_t side = 0; // which child of the parent; without a parent it is the root
};

class WidePieces {
  public:
    struct Items {
        Id first, count;
        bool fit_leaf; // into one leaf of the wide tree
    };
    // Whether up to eight primitives fit into a leaf; every leaf of the binary tree must.
    using Fits = std::function<bool(std::span<const Id>)>;

    WidePieces(Tree binary, const Fits &fits) : tree_(std::move(binary)), items_(tree_.nodes.size()) {
        // Children come after their parents in the binary tree, so backwards each node comes after its children.
        for (std::size_t i = items_.size(); i-- > 0;) {
            const Items a = items_of(tree_.nodes[i].children[0]), b = items_of(tree_.nodes[i].children[1]);
            const Id count = a.count + b.count;
            const bool may = a.fit_leaf && b.fit_leaf && count <= lanes;
            items_[i] = {a.first, count, may && fits(std::span(tree_.order).subspan(a.first, count))};
        }
    }

    const Tree &tree() const { return tree_; }
    std::vector<Id> take_order() { return std::move(tree_.order); }
    WidePiece root() const { return {tree_.root, area_of(tree_.box)}; }
    WidePiece child(Link link, std::size_t side) const {
        const Node &node = tree_.nodes[link.first];
        float e[3];
        for (int axis = 0; axis < 3; ++axis)
            e[axis] = node.planes[axis][1][side] - node.planes[axis][0][side];
        return {node.children[side], e[0] * e[1] + e[1] * e[2] + e[2] * e[0], &node, side};
    }
    Items items_of(Link link) const {
        return link.is_leaf() ? Items{link.first, link.count, true} : items_[link.first];
    }

    // One side of the box along an axis: 0 the low one, 1 the high one.
    float plane(const WidePiece &piece, int axis, int high) const {
        if (piece.parent)
            return piece.parent->planes[axis][high][piece.side];
        return high ? tree_.box.hi[axis] : tree_.box.lo[axis];
    }

  private:
    static float area_of(const Box<float> &box) {
        const Vec<float> e = box.hi - box.lo;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }

    Tree tree_;
    std::vector<Items> items_; // of each node
};

} // namespace course
