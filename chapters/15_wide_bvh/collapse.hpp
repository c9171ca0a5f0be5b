// Lesson 15, step 3c: from chapter 14's binary tree to one with eight children a node.
#pragma once
#include "chapters/15_wide_bvh/cuts.hpp"
#include "chapters/15_wide_bvh/large_pages.hpp"
#include "chapters/15_wide_bvh/options.hpp"

#include <optional>
#include <stdexcept>

namespace course {

struct WideTree {
    LargeVector<WideNode> nodes; // the root first; none where there is nothing to hit
    std::vector<Id> order;       // the primitives as the leaves hold them
    Box<float> box = empty_box();
    float reach = 0; // the largest coordinate
};

class Collapser {
  public:
    Collapser(Tree binary, const WidePieces::Fits &fits, WideOptions::Collapse how, const WideCosts &costs)
        : pieces_(std::move(binary), fits) {
        if (pieces_.tree().order.size() >= WideLink::most)
            throw std::length_error("more primitives than a wide tree can name");
        if (how == WideOptions::Collapse::optimal)
            best_.emplace(pieces_, costs);
    }

    WideTree collapse() && {
        const Box<float> &box = pieces_.tree().box;
        WideTree tree{{}, {}, box, static_cast<float>(largest_coordinate(box))};
        tree.nodes.reserve(pieces_.tree().nodes.size() / 4 + 1); // as good as always enough
        if (!pieces_.tree().order.empty())
            emit(pieces_.root(), tree.nodes);
        tree.order = pieces_.take_order();
        return tree;
    }

  private:
    bool becomes_leaf(const WidePiece &piece) const {
        return best_ ? best_->becomes_leaf(piece) : piece.link.is_leaf();
    }

    WideChildren children_of(const WidePiece &piece) const {
        if (piece.parent == nullptr && becomes_leaf(piece))
            return {piece}; // the whole scene fits into a leaf
        return best_ ? (*best_)(piece) : cut_greedily(pieces_, piece);
    }

    // Each node before its children, the nodes of one child side by side.
    Id emit(const WidePiece &piece, LargeVector<WideNode> &nodes) const {
        const WideChildren children = children_of(piece);
        const Id number = static_cast<Id>(nodes.size());
        nodes.push_back(empty_node());
        for (std::size_t i = 0; i < children.size(); ++i) {
            for (int axis = 0; axis < 3; ++axis)
                for (const int high : {0, 1})
                    nodes[number].planes[axis][high][i] = pieces_.plane(children[i], axis, high);
            const auto items = pieces_.items_of(children[i].link);
            const WideLink link = becomes_leaf(children[i]) ? WideLink::leaf(items.first, items.count)
                                                            : WideLink::node(emit(children[i], nodes));
            nodes[number].links[i] = link; // only now: the nodes may have moved
        }
        set_order(nodes[number]);
        return number;
    }

    // Should numbers beyond all bounds make a ray enter it, a child that is not there is some leaf.
    static WideNode empty_node() {
        WideNode node;
        for (auto &[low, high] : node.planes) {
            std::ranges::fill(low, infinity<float>);
            std::ranges::fill(high, -infinity<float>);
        }
        std::ranges::fill(node.links, WideLink::leaf(0, 1));
        return node;
    }

    static void set_order(WideNode &node) {
        for (unsigned octant = 0; octant < 8; ++octant) {
            const auto depth = [&](unsigned child) {
                float sum = 0;
                for (unsigned axis = 0; axis < 3; ++axis) {
                    const float middle = 0.5f * node.planes[axis][0][child] + 0.5f * node.planes[axis][1][child];
                    sum += octant >> axis & 1 ? -middle : middle;
                }
                return sum == sum ? sum : -infinity<float>; // NaN for a child that is not there
            };
            std::array<float, lanes> depths;
            std::array<unsigned, lanes> sorted;
            for (unsigned i = 0; i < lanes; ++i) {
                depths[i] = depth(i);
                unsigned place = i;
                for (; place > 0 && depths[sorted[place - 1]] < depths[i]; --place)
                    sorted[place] = sorted[place - 1];
                sorted[place] = i;
            }
            node.far_first[octant] = 0;
            for (unsigned i = 0; i < lanes; ++i)
                node.far_first[octant] |= sorted[i] << 3 * i;
        }
    }

    WidePieces pieces_;
    std::optional<BestCut> best_; // none for the greedy collapse
};

} // namespace course
