// Lesson 15, step 3: from chapter 14's binary tree to one with eight children a node.
#pragma once
#include "chapters/14_bvh/build.hpp"
#include "chapters/15_wide_bvh/options.hpp"
#include "chapters/15_wide_bvh/wide_node.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace course {

struct WideTree {
    std::vector<WideNode> nodes; // the root first; none where there is nothing to hit
    std::vector<Id> order;       // the primitives as the leaves hold them
    Box<float> box = empty_box();
    float reach = 0; // the largest coordinate
};

// What a leaf costs, in units of a node: for how many primitives it holds.
struct WideCosts {
    float leaf, primitive;

    float of(Id count) const { return leaf + primitive * static_cast<float>(count); }
};

class Collapser {
  public:
    Collapser(Tree binary, WideOptions::Collapse how, const WideCosts &costs)
        : from_(std::move(binary)), costs_(costs) {
        if (from_.order.size() >= WideLink::most)
            throw std::length_error("more primitives than a wide tree can name");
        count_items();
        if (how == WideOptions::Collapse::optimal)
            find_costs();
    }

    WideTree collapse() && {
        WideTree tree{{}, {}, from_.box, static_cast<float>(largest_coordinate(from_.box))};
        if (!from_.order.empty())
            emit({from_.root, area_of(from_.box)}, tree.nodes);
        tree.order = std::move(from_.order);
        return tree;
    }

  private:
    // A piece of the binary tree: a leaf, or all below a node.
    struct Piece {
        Link link;
        float area; // of half the surface
        const Node *parent = nullptr;
        std::size_t side = 0; // which child of the parent; without a parent it is the root
    };
    using Row = std::array<float, lanes>; // [k - 1]: the least cost of a piece as at most k children of a wide node
    struct Items {
        Id first, count;
    };

    static float area_of(const Box<float> &box) {
        const Vec<float> e = box.hi - box.lo;
        return e.x * e.y + e.y * e.z + e.z * e.x;
    }
    static Piece child(const Node &node, std::size_t side) {
        float e[3];
        for (int axis = 0; axis < 3; ++axis)
            e[axis] = node.planes[axis][1][side] - node.planes[axis][0][side];
        return {node.children[side], e[0] * e[1] + e[1] * e[2] + e[2] * e[0], &node, side};
    }
    const Node &node_of(Link link) const { return from_.nodes[link.first]; }
    Items items_of(Link link) const { return link.is_leaf() ? Items{link.first, link.count} : items_[link.first]; }

    // Children come after their parents in the binary tree, so backwards each node comes after its children.
    void count_items() {
        items_.resize(from_.nodes.size());
        for (std::size_t i = items_.size(); i-- > 0;) {
            const Items a = items_of(from_.nodes[i].children[0]), b = items_of(from_.nodes[i].children[1]);
            items_[i] = {a.first, a.count + b.count};
        }
    }

    // ---- The best cut by dynamic programming
    // -------------------------------------------------------------------------

    float cost_as_leaf(const Piece &piece) const {
        const Id count = items_of(piece.link).count;
        return count <= lanes ? piece.area * costs_.of(count) : infinity<float>;
    }
    Row row_of(const Piece &piece) const {
        if (!piece.link.is_leaf())
            return rows_[piece.link.first];
        Row row;
        row.fill(cost_as_leaf(piece));
        return row;
    }
    // The best share of k children between the two halves of a node: how many for the first, and the cost.
    static std::pair<unsigned, float> best_share(const Row &a, const Row &b, unsigned k) {
        std::pair<unsigned, float> best{1, a[0] + b[k - 2]};
        for (unsigned i = 2; i < k; ++i)
            if (const float cost = a[i - 1] + b[k - i - 1]; cost < best.second)
                best = {i, cost};
        return best;
    }
    float cost_as_node(const Piece &piece, const Row &a, const Row &b) const {
        return piece.area + best_share(a, b, lanes).second;
    }
    void find_costs() {
        rows_.resize(from_.nodes.size());
        std::vector<float> areas(from_.nodes.size());
        if (!areas.empty())
            areas[0] = area_of(from_.box);
        for (const Node &node : from_.nodes)
            for (const std::size_t side : {0u, 1u})
                if (const Piece piece = child(node, side); !piece.link.is_leaf())
                    areas[piece.link.first] = piece.area;
        for (std::size_t i = rows_.size(); i-- > 0;) {
            const Piece piece{{static_cast<Id>(i), 0}, areas[i]};
            const Row a = row_of(child(from_.nodes[i], 0)), b = row_of(child(from_.nodes[i], 1));
            Row &row = rows_[i];
            row[0] = std::min(cost_as_leaf(piece), cost_as_node(piece, a, b));
            for (unsigned k = 2; k <= lanes; ++k)
                row[k - 1] = std::min(row[0], best_share(a, b, k).second);
        }
    }

    bool becomes_leaf(const Piece &piece) const {
        if (piece.link.is_leaf() || rows_.empty())
            return piece.link.is_leaf();
        return items_of(piece.link).count <= lanes && cost_as_leaf(piece) <= rows_[piece.link.first][0];
    }
    // The pieces that become children where this piece may have k of them.
    void share(const Piece &piece, unsigned k, std::vector<Piece> &children) const {
        if (piece.link.is_leaf() || k == 1 || rows_[piece.link.first][k - 1] == rows_[piece.link.first][0])
            children.push_back(piece);
        else
            open(piece, k, children);
    }
    void open(const Piece &piece, unsigned k, std::vector<Piece> &children) const {
        const Piece a = child(node_of(piece.link), 0), b = child(node_of(piece.link), 1);
        const unsigned first = best_share(row_of(a), row_of(b), k).first;
        share(a, first, children);
        share(b, k - first, children);
    }

    // ---- The simple way
    // ----------------------------------------------------------------------------------------------

    // As long as there is room, the piece with the largest surface gives way to its two halves.
    void open_greedily(const Piece &piece, std::vector<Piece> &children) const {
        children = {child(node_of(piece.link), 0), child(node_of(piece.link), 1)};
        while (children.size() < lanes) {
            const auto largest = std::ranges::max_element(
                children, {}, [](const Piece &p) { return p.link.is_leaf() ? -1.0f : p.area; });
            if (largest->link.is_leaf())
                return;
            const Node &node = node_of(largest->link);
            *largest = child(node, 0);
            children.push_back(child(node, 1));
        }
    }

    // ---- Writing the nodes
    // -------------------------------------------------------------------------------------------

    // Each node before its children, the nodes of one child side by side.
    Id emit(const Piece &piece, std::vector<WideNode> &nodes) const {
        std::vector<Piece> children;
        if (piece.link.is_leaf() || (piece.parent == nullptr && becomes_leaf(piece)))
            children = {piece}; // the whole scene fits into a leaf
        else if (rows_.empty())
            open_greedily(piece, children);
        else
            open(piece, lanes, children);

        const Id number = static_cast<Id>(nodes.size());
        nodes.push_back(empty_node());
        for (std::size_t i = 0; i < children.size(); ++i) {
            set_box(nodes[number], i, children[i]);
            const Items items = items_of(children[i].link);
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

    void set_box(WideNode &node, std::size_t i, const Piece &piece) const {
        for (int axis = 0; axis < 3; ++axis) {
            node.planes[axis][0][i] = piece.parent ? piece.parent->planes[axis][0][piece.side] : from_.box.lo[axis];
            node.planes[axis][1][i] = piece.parent ? piece.parent->planes[axis][1][piece.side] : from_.box.hi[axis];
        }
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
            std::array<unsigned, lanes> sorted;
            std::iota(sorted.begin(), sorted.end(), 0u);
            std::ranges::stable_sort(sorted, [&](unsigned a, unsigned b) { return depth(a) > depth(b); });
            node.far_first[octant] = 0;
            for (unsigned i = 0; i < lanes; ++i)
                node.far_first[octant] |= sorted[i] << 3 * i;
        }
    }

    Tree from_;
    WideCosts costs_;
    std::vector<Items> items_; // of each binary node
    std::vector<Row> rows_;    // of each binary node; none for the greedy collapse
};

} // namespace course
