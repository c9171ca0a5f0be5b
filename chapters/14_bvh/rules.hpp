// Lesson 14, step 3: where to cut a list of primitives in two.
#pragma once
#include "chapters/14_bvh/four.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace course {

// What a builder moves about: a primitive's box, and which primitive it is.
struct Item {
    Box4 box;
    std::uint32_t id;
};

inline Box4 box_of(std::span<const Item> items) {
    Box4 box = Box4::empty();
    for (const Item &item : items)
        box.include(item.box);
    return box;
}

// A rule is called with items and the box around them. It puts those for the first child in front and returns how many
// they are; or returns 0, to make a leaf of them all, which it does only up to its largest_leaf.

// The notes' rule (A 2.3, B §4): across the longest axis, in the middle of the order. nth_element finds the median in
// linear time without sorting either half.
struct LongestAxisMedian {
    std::size_t largest_leaf = 4;

    std::size_t operator()(std::span<Item> items, const Box4 &box) const {
        if (items.size() <= largest_leaf)
            return 0;
        const Four e = box.hi - box.lo;
        const int axis = e[0] > e[1] ? (e[0] > e[2] ? 0 : 2) : (e[1] > e[2] ? 1 : 2);
        const std::size_t half = items.size() / 2;
        std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                         [axis](const Item &a, const Item &b) { return a.box.middle()[axis] < b.box.middle()[axis]; });
        return half;
    }
};

// The surface area heuristic (MacDonald and Booth 1990), over the borders of 16 bins an axis (Wald 2007).
struct BinnedSah {
    std::size_t largest_leaf = 8;
    float node_cost = 2; // in units of a primitive's test

    std::size_t operator()(std::span<Item> items, const Box4 &box) const {
        if (items.size() < 2)
            return 0;
        const Bins bins(items);
        const Cut best = cheapest_cut(items, bins);

        // A leaf costs a test for each item; a cut, one more node and the children's items, as often as they are hit.
        const float as_leaf = box.half_area() * (static_cast<float>(items.size()) - node_cost);
        if (items.size() <= largest_leaf && !(best.cost < as_leaf))
            return 0;
        if (!(best.cost < infinity<float>))
            return items.size() / 2; // no border separates anything
        const auto right = std::partition(items.begin(), items.end(), [&](const Item &item) {
            return bins.of(item.box)[best.axis] <= best.last_left;
        });
        return static_cast<std::size_t>(right - items.begin());
    }

  private:
    static constexpr std::size_t most_bins = 16;

    // Bins of equal width along each axis, between the first and the last middle of a box. Few items need few bins.
    struct Bins {
        std::size_t count;
        Four begin, per_unit, last;

        explicit Bins(std::span<const Item> items) : count(std::min(items.size(), most_bins)) {
            Box4 middles = Box4::empty();
            for (const Item &item : items)
                middles.include({item.box.middle(), item.box.middle()});
            begin = middles.lo;
            per_unit = static_cast<float>(count) / (middles.hi - middles.lo);
            last = Four{} + static_cast<float>(count - 1);
        }

        // Where all middles of an axis are the same, 0 times infinity puts all into the last bin.
        FourInts of(const Box4 &box) const {
            const Four place = (box.middle() - begin) * per_unit;
            return __builtin_convertvector(place < last ? place : last, FourInts);
        }
    };

    struct Bin {
        Box4 box;
        float items;

        void include(const Bin &other) {
            box.include(other.box);
            items += other.items;
        }
        float cost() const { return box.half_area() * items; }
    };
    using Row = std::array<Bin, most_bins>; // one axis

    struct Cut {
        float cost = infinity<float>;
        int axis = 0, last_left = 0; // bins up to this one go left
    };

    static Cut cheapest_cut(std::span<const Item> items, const Bins &bins) {
        std::array<Row, 3> rows;
        for (Row &row : rows)
            std::fill_n(row.begin(), bins.count, Bin{Box4::empty(), 0});
        for (const Item &item : items) {
            const FourInts place = bins.of(item.box);
            for (int axis = 0; axis < 3; ++axis)
                rows[static_cast<std::size_t>(axis)][static_cast<std::size_t>(place[axis])].include({item.box, 1});
        }
        Cut best;
        for (int axis = 0; axis < 3; ++axis)
            improve(best, axis, std::span(rows[static_cast<std::size_t>(axis)]).first(bins.count));
        return best;
    }

    // Tries every border between two bins: what lies right of each is added up from the right, then left from the left.
    static void improve(Cut &best, int axis, std::span<const Bin> row) {
        std::array<float, most_bins> right;
        Bin sum{Box4::empty(), 0};
        for (std::size_t i = row.size() - 1; i > 0; --i) {
            sum.include(row[i]);
            right[i] = sum.items > 0 ? sum.cost() : infinity<float>;
        }
        sum = {Box4::empty(), 0};
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            sum.include(row[i]);
            const float cost = sum.items > 0 ? sum.cost() + right[i + 1] : infinity<float>;
            if (cost < best.cost)
                best = {cost, axis, static_cast<int>(i)};
        }
    }
};

} // namespace course
