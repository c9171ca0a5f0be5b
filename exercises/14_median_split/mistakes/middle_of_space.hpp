// Mistake: the list is split where the middle of the box is, and so not in halves.
// Caught by: half of them go to each child, ordered along the axis
#pragma once
#include "exercises/14_median_split/task.hpp"

namespace course::exercise {

inline std::size_t split(std::span<BuildItem> items) {
    Box<float> box{Vec<float>(infinity<float>), Vec<float>(-infinity<float>)};
    for (const BuildItem &item : items)
        box = {min(box.lo, item.box.lo), max(box.hi, item.box.hi)};
    const Vec<float> edges = box.hi - box.lo;
    const int axis = edges.x >= edges.y ? (edges.x >= edges.z ? 0 : 2) : (edges.y >= edges.z ? 1 : 2);
    const float at = 0.5f * (box.lo[axis] + box.hi[axis]);
    const auto second =
        std::partition(items.begin(), items.end(), [&](const BuildItem &item) { return item.middle(axis) < at; });
    return static_cast<std::size_t>(second - items.begin());
}

inline constexpr Task task{split};

} // namespace course::exercise
