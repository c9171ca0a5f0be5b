// Mistake: the next border is always taken for the upper side of the cell.
// Caught by: the ray may run backwards along an axis
#pragma once
#include "exercises/10_grid_walk/task.hpp"

namespace course::exercise {

inline std::vector<glm::ivec3> cells_along(const Ray<double> &ray, const SmallGrid &grid) {
    glm::ivec3 cell, step;
    Vec<double> next, between; // the t of the next border along each axis, and from one border to the next
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (ray.origin[axis] - grid.lo[axis]) / grid.size, d = ray.direction[axis];
        cell[axis] = static_cast<int>(std::floor(place));
        step[axis] = d > 0 ? 1 : -1;
        const double border = cell[axis] + 1;
        next[axis] = d == 0 ? infinity<double> : (border - place) * grid.size / d;
        between[axis] = d == 0 ? infinity<double> : grid.size / std::abs(d);
    }

    std::vector<glm::ivec3> cells;
    double enter = ray.t_min;
    while (grid.has(cell) && enter < ray.t_max) {
        cells.push_back(cell);
        const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
        enter = next[axis];
        cell[axis] += step[axis];
        next[axis] += between[axis];
    }
    return cells;
}

inline constexpr Task task{cells_along};

} // namespace course::exercise
