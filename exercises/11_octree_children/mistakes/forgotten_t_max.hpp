// Mistake: crossings beyond the end of the ray count.
// Caught by: nothing beyond t_max is visited
#pragma once
#include "exercises/11_octree_children/task.hpp"

namespace course::exercise {

inline std::vector<int> children_met(const Ray<double> &ray, const Box<double> &cell) {
    double enter = ray.t_min, exit = infinity<double>;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0 && (o < cell.lo[axis] || o > cell.hi[axis]))
            return {};
        if (d != 0) {
            enter = std::max(enter, ((d > 0 ? cell.lo : cell.hi)[axis] - o) / d);
            exit = std::min(exit, ((d > 0 ? cell.hi : cell.lo)[axis] - o) / d);
        }
    }
    if (!(enter < exit))
        return {};

    int child = 0;
    double crossed[3]; // when the ray crosses the middle plane of each axis
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        const double middle = 0.5 * (cell.lo[axis] + cell.hi[axis]);
        crossed[axis] = d == 0 ? infinity<double> : (middle - o) / d;
        const bool behind_plane = crossed[axis] <= enter;
        const bool upper = d == 0 ? o > middle : (d > 0) == behind_plane;
        child |= static_cast<int>(upper) << axis;
        if (behind_plane)
            crossed[axis] = infinity<double>;
    }

    std::vector<int> children{child};
    while (true) {
        const int axis = static_cast<int>(std::min_element(crossed, crossed + 3) - crossed);
        if (!(crossed[axis] < exit))
            return children;
        crossed[axis] = infinity<double>;
        child ^= 1 << axis;
        children.push_back(child);
    }
}

inline constexpr Task task{children_met};

} // namespace course::exercise
