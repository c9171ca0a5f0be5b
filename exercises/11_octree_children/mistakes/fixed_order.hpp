// Mistake: all eight children, in an order that depends on the signs of the direction alone: near before far, but most
// are not met. Caught by: a ray that runs upwards meets its children in order
#pragma once
#include "exercises/11_octree_children/task.hpp"

namespace course::exercise {

inline std::vector<int> children_met(const Ray<double> &ray, const Box<double> &cell) {
    double enter = ray.t_min, exit = ray.t_max;
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

    child = (ray.direction.x < 0) | (ray.direction.y < 0) << 1 | (ray.direction.z < 0) << 2;
    std::vector<int> children;
    for (int i = 0; i < 8; ++i)
        children.push_back(i ^ child);
    return children;
}

inline constexpr Task task{children_met};

} // namespace course::exercise
