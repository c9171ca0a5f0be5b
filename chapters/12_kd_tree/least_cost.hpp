// Lesson 12, step 3: where to cut, so that rays have the least to do, and when to stop.
#pragma once
#include "chapters/12_kd_tree/rules.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace course {

// The surface area heuristic (MacDonald and Booth 1990): a ray that meets the cell meets a part of it with the
// probability of the part's surface over the cell's. A cut costs a step, and then the tests in each part as often as
// the part is met. A box around what is in the cell costs a step too, and then the tests as often as the box is met. If
// neither is cheaper than testing all items at once, the cell is a leaf.
struct LeastCost {
    static constexpr std::size_t exact_up_to = 64; // with more items, planes are tried where 64 bins meet
    float test_cost = 0.5f;                        // in units of a step
    float box_cost = 1;

    static int depth_limit(std::size_t) { return deepest_kd_leaf; } // it stops by itself

    KdCut operator()(std::span<const KdItem> items, const Box<float> &cell, int) const {
        Best best{{}, test_cost * static_cast<float>(items.size())};
        try_box(items, cell, best);
        for (int axis = 0; axis < 3; ++axis) {
            if (!(cell.lo[axis] < cell.hi[axis]))
                continue;
            if (items.size() <= exact_up_to)
                try_all_sides(items, cell, axis, best);
            else
                try_bins(items, cell, axis, best);
        }
        return best.cut;
    }

  private:
    struct Best {
        KdCut cut;
        float cost;
    };

    void try_box(std::span<const KdItem> items, const Box<float> &cell, Best &best) const {
        const auto share = static_cast<float>(surface_area(box_of(items)) / surface_area(cell));
        const float cost = box_cost + share * test_cost * static_cast<float>(items.size());
        if (cost < best.cost)
            best = {{KdCut::box}, cost};
    }

    // A cut that cuts off nothing but air is left to the box, which cuts it off on all sides at once.
    void try_cut(const Box<float> &cell, const KdCut &cut, std::size_t below, std::size_t above, Best &best) const {
        if (!(cut.at > cell.lo[cut.axis] && cut.at < cell.hi[cut.axis]) || below == 0 || above == 0)
            return;
        const Vec<float> e = cell.hi - cell.lo;
        const int u = (cut.axis + 1) % 3, v = (cut.axis + 2) % 3;
        const float cap = e[u] * e[v], round = e[u] + e[v];
        const auto share = [&](float from, float to) { // of the cell's surface
            return (cap + (to - from) * round) / (cap + e[cut.axis] * round);
        };
        const float tests = share(cell.lo[cut.axis], cut.at) * static_cast<float>(below) +
                            share(cut.at, cell.hi[cut.axis]) * static_cast<float>(above);
        if (const float cost = 1 + test_cost * tests; cost < best.cost)
            best = {cut, cost};
    }

    // The cost changes only where a box begins or ends.
    void try_all_sides(std::span<const KdItem> items, const Box<float> &cell, int axis, Best &best) const {
        std::array<float, exact_up_to> memory_of_begins, memory_of_ends, memory_of_flat;
        const auto begins = std::span(memory_of_begins).first(items.size());
        const auto ends = std::span(memory_of_ends).first(items.size());
        std::size_t flat_ones = 0;
        for (std::size_t i = 0; i < items.size(); ++i) {
            begins[i] = items[i].box.lo[axis];
            ends[i] = items[i].box.hi[axis];
            if (begins[i] == ends[i])
                memory_of_flat[flat_ones++] = begins[i];
        }
        const auto flat = std::span(memory_of_flat).first(flat_ones);
        std::ranges::sort(begins);
        std::ranges::sort(ends);
        std::ranges::sort(flat);
        for (const auto &sides : {begins, ends})
            for (const float at : sides) {
                const auto in_plane = std::ranges::equal_range(flat, at).size(); // goes_below() takes them
                const auto below = std::ranges::lower_bound(begins, at) - begins.begin();
                const auto above = ends.end() - std::ranges::upper_bound(ends, at);
                try_cut(cell, {axis, at}, in_plane + std::size_t(below), std::size_t(above), best);
            }
    }

    // Planes where two bins meet. The counts there are never too small from the last box that ends before to the first
    // that begins behind, so both these places are tried as well: there a plane is flush with a wall, if there is one.
    void try_bins(std::span<const KdItem> items, const Box<float> &cell, int axis, Best &best) const {
        constexpr std::size_t bins = 64;
        std::array<std::size_t, bins> begins{}, ends{};
        const float lo = cell.lo[axis], width = (0.5f * cell.hi[axis] - 0.5f * lo) / bins * 2;
        const auto bin_of = [&](float x) {
            const float place = (x - lo) / width;
            return place > 0 ? static_cast<std::size_t>(std::min(place, bins - 1.0f)) : std::size_t{0};
        };
        std::array<float, bins> first_begin, last_end;
        std::array<std::size_t, bins> first_flat{}; // how many boxes are flat there
        first_begin.fill(cell.hi[axis]);
        last_end.fill(lo);
        for (const KdItem &item : items) {
            const float begin = item.box.lo[axis], end = item.box.hi[axis];
            const std::size_t from = bin_of(begin), to = bin_of(end);
            ++begins[from];
            ++ends[to];
            if (begin < first_begin[from]) {
                first_begin[from] = begin;
                first_flat[from] = 0;
            }
            first_flat[from] += begin == first_begin[from] && begin == end;
            last_end[to] = std::max(last_end[to], end);
        }
        std::size_t below = 0, above = items.size();
        for (std::size_t bin = 1; bin < bins; ++bin) {
            below += begins[bin - 1];
            above -= ends[bin - 1];
            const float border = lo + static_cast<float>(bin) * width;
            for (const float at : {last_end[bin - 1], border, first_begin[bin]}) {
                const std::size_t in_plane = at == first_begin[bin] ? first_flat[bin] : 0; // goes_below() takes them
                try_cut(cell, {axis, at}, below + in_plane, above - in_plane, best);
            }
        }
    }
};

} // namespace course
