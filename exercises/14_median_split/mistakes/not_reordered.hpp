// Mistake: half of the list as it comes, without any order.
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
    std::swap(items[0], items[static_cast<std::size_t>(axis) % items.size()]);
    return items.size() / 2;
}

inline constexpr Task task{split};

} // namespace course::exercise
