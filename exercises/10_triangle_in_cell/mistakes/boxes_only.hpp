// Mistake: only the boxes are compared.
// Caught by: a triangle whose plane passes the cell by does not
#pragma once
#include "exercises/10_triangle_in_cell/task.hpp"

namespace course::exercise {

inline bool overlaps(const Triangle<float> &triangle, const Box<double> &box) {
    const Vec<double> middle = 0.5 * (box.lo + box.hi), half = 0.5 * (box.hi - box.lo);
    const Vec<double> a = Vec<double>(triangle.a) - middle, b = Vec<double>(triangle.b) - middle;
    const Vec<double> c = Vec<double>(triangle.c) - middle;
    const auto apart = [&](const Vec<double> &line) {
        const double pa = dot(line, a), pb = dot(line, b), pc = dot(line, c);
        const double reach = dot(abs(line), half);
        return std::min({pa, pb, pc}) > reach || std::max({pa, pb, pc}) < -reach;
    };
    const Vec<double> axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vec<double> &axis : axes)
        if (apart(axis))
            return false;
    return true;
}

inline constexpr Task task{overlaps};

} // namespace course::exercise
