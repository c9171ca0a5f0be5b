// Lesson 15, step 3b: which pieces become the eight children of a wide node.
#pragma once
#include "chapters/15_wide_bvh/pieces.hpp"

#include <algorithm>
#include <array>

namespace course {

using WideChildren = std::vector<WidePiece>;

// The simple way. As long as there is room, the piece with the largest surface gives way to its two halves.
inline WideChildren cut_greedily(const WidePieces &pieces, const WidePiece &piece) {
    WideChildren children{pieces.child(piece.link, 0), pieces.child(piece.link, 1)};
    while (children.size() < lanes) {
        const auto largest = std::ranges::max_element(
            children, {}, [](const WidePiece &p) { return p.link.is_leaf() ? -1.0f : p.area; });
        if (largest->link.is_leaf())
            break;
        const Link opened = largest->link;
        *largest = pieces.child(opened, 0);
        children.push_back(pieces.child(opened, 1));
    }
    return children;
}

// What a leaf costs, in units of a node: for how many primitives it holds.
struct WideCosts {
    float leaf, primitive;

    float of(Id count) const { return leaf + primitive * static_cast<float>(count); }
};

// The best way, by dynamic programming.
class BestCut {
  public:
    BestCut(const WidePieces &pieces, const WideCosts &costs) : pieces_(pieces), costs_(costs) {
        const auto &nodes = pieces.tree().nodes;
        rows_.resize(nodes.size());
        std::vector<float> areas(nodes.size());
        if (!areas.empty())
            areas[0] = pieces.root().area;
        for (Id i = 0; i < nodes.size(); ++i)
            for (const std::size_t side : {0u, 1u})
                if (const WidePiece piece = pieces.child({i, 0}, side); !piece.link.is_leaf())
                    areas[piece.link.first] = piece.area;
        for (auto i = static_cast<Id>(rows_.size()); i-- > 0;) {
            const WidePiece piece{{i, 0}, areas[i]};
            const Row a = row_of(pieces.child(piece.link, 0)), b = row_of(pieces.child(piece.link, 1));
            Row &row = rows_[i];
            row[0] = std::min(cost_as_leaf(piece), cost_as_node(piece, a, b));
            for (unsigned k = 2; k <= lanes; ++k)
                row[k - 1] = std::min(row[0], best_share(a, b, k).second);
        }
    }

    bool becomes_leaf(const WidePiece &piece) const {
        if (piece.link.is_leaf())
            return true;
        return pieces_.items_of(piece.link).fit_leaf && cost_as_leaf(piece) <= rows_[piece.link.first][0];
    }
    WideChildren operator()(const WidePiece &piece) const {
        WideChildren children;
        open(piece, lanes, children);
        return children;
    }

  private:
    using Row = std::array<float, lanes>; // [k - 1]: the least cost of a piece as at most k children of a wide node

    float cost_as_leaf(const WidePiece &piece) const {
        const auto items = pieces_.items_of(piece.link);
        return items.fit_leaf ? piece.area * costs_.of(items.count) : infinity<float>;
    }
    static float cost_as_node(const WidePiece &piece, const Row &a, const Row &b) {
        return piece.area + best_share(a, b, lanes).second;
    }
    Row row_of(const WidePiece &piece) const {
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

    // The pieces that become children where this piece may have k of them.
    void share(const WidePiece &piece, unsigned k, WideChildren &children) const {
        if (piece.link.is_leaf() || k == 1 || rows_[piece.link.first][k - 1] == rows_[piece.link.first][0])
            children.push_back(piece);
        else
            open(piece, k, children);
    }
    void open(const WidePiece &piece, unsigned k, WideChildren &children) const {
        const WidePiece a = pieces_.child(piece.link, 0), b = pieces_.child(piece.link, 1);
        const unsigned first = best_share(row_of(a), row_of(b), k).first;
        share(a, first, children);
        share(b, k - first, children);
    }

    const WidePieces &pieces_;
    WideCosts costs_;
    std::vector<Row> rows_; // of each node
};

} // namespace course
