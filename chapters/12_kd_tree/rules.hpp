// Lesson 12, step 2: where to cut, by the notes: the middle of the cell or the median of the objects, axis after axis.
#pragma once
#include "chapters/09_aabb/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace course {

// A shape in a cell: the part of its box within the cell, and whose it is.
struct KdItem {
    Box<float> box;
    Id id;
};

// Across an axis; or no cut: a leaf, or a box around what is in the cell.
struct KdCut {
    static constexpr int leaf = 3, box = 4;
    int axis = leaf;
    float at = 0;
};

inline Box<float> box_of(std::span<const KdItem> items) {
    Box<float> box = empty_box();
    for (const KdItem &item : items)
        box = merge(box, item.box);
    return box;
}

// Who goes where. What only touches the plane goes to its own side, what lies in it goes to the lower one. A ray that
// meets it exactly there looks at both sides: see SplitRay.
inline bool goes_below(const Box<float> &box, const KdCut &cut) {
    return box.lo[cut.axis] < cut.at || box.hi[cut.axis] <= cut.at;
}
inline bool goes_above(const Box<float> &box, const KdCut &cut) { return box.hi[cut.axis] > cut.at; }

// No leaf lies deeper, whatever the rule, so no walk ever has more cells waiting.
inline constexpr int deepest_kd_leaf = 60;

// A rule that does not ask what a cut is worth has to be stopped: in a balanced tree the leaves lie log2(n) deep, here
// some may lie deeper, and none much more than half as deep again.
inline int depth_for_balance(std::size_t items) {
    return std::min(static_cast<int>(8 + 1.3 * std::log2(static_cast<double>(items) + 1)), deepest_kd_leaf);
}

// The notes' rule: x, y and z take turns (B §4), and each cut halves the cell.
struct MiddleOfCell {
    std::size_t largest_leaf = 4;

    static int depth_limit(std::size_t items) { return depth_for_balance(items); }

    KdCut operator()(std::span<const KdItem> items, const Box<float> &cell, int depth) const {
        const int axis = depth % 3;
        return items.size() <= largest_leaf ? KdCut{} : KdCut{axis, 0.5f * cell.lo[axis] + 0.5f * cell.hi[axis]};
    }
};

// The same, but each cut halves the objects: as many middles below as above.
struct MedianOfObjects {
    std::size_t largest_leaf = 4;

    static int depth_limit(std::size_t items) { return depth_for_balance(items); }

    KdCut operator()(std::span<const KdItem> items, const Box<float> &, int depth) const {
        if (items.size() <= largest_leaf)
            return {};
        const int axis = depth % 3;
        std::vector<float> middles;
        for (const KdItem &item : items)
            middles.push_back(0.5f * item.box.lo[axis] + 0.5f * item.box.hi[axis]);
        const auto half = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
        std::ranges::nth_element(middles, half);
        return {axis, *half};
    }
};

} // namespace course
