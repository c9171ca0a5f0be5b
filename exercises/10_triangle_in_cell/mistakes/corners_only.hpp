// Mistake: a triangle counts only if one of its corners is in the cell.
// Caught by: a triangle that reaches through the cell with its middle does
#pragma once
#include "exercises/10_triangle_in_cell/task.hpp"

namespace course::exercise {

inline bool overlaps(const Triangle<float> &triangle, const Box<double> &box) {
    const Vec<double> middle = 0.5 * (box.lo + box.hi), half = 0.5 * (box.hi - box.lo);
    const Vec<double> a = Vec<double>(triangle.a) - middle, b = Vec<double>(triangle.b) - middle;
    const Vec<double> c = Vec<double>(triangle.c) - middle;
    for (const Vec<double> &corner : {a, b, c})
        if (std::abs(corner.x) <= half.x && std::abs(corner.y) <= half.y && std::abs(corner.z) <= half.z)
            return true;
    return false;
}

inline constexpr Task task{overlaps};

} // namespace course::exercise
