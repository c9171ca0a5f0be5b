// Exercise 14, solved: where does a BVH split its primitives.
#pragma once
#include "exercises/14_median_split/task.hpp"

namespace course::exercise {

inline std::size_t split(std::span<BuildItem> items) {
    Box<float> box{Vec<float>(infinity<float>), Vec<float>(-infinity<float>)};
    for (const BuildItem &item : items)
        box = {min(box.lo, item.box.lo), max(box.hi, item.box.hi)};
    const Vec<float> edges = box.hi - box.lo;
    const int axis = edges.x >= edges.y ? (edges.x >= edges.z ? 0 : 2) : (edges.y >= edges.z ? 1 : 2);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const BuildItem &a, const BuildItem &b) { return a.middle(axis) < b.middle(axis); });
    return half;
}

inline constexpr Task task{split};

} // namespace course::exercise
