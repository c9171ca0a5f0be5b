// Mistake: a box that lies in the plane is counted on neither side.
// Caught by: boxes without thickness are not lost, nor counted twice
#pragma once
#include "exercises/12_sah_cut/task.hpp"

namespace course::exercise {

inline std::optional<CellCut> best_cut(std::span<const Box<float>> boxes, const Box<float> &cell) {
    std::optional<CellCut> best;
    double least = static_cast<double>(boxes.size()); // of a leaf
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> planes;
        for (const Box<float> &box : boxes)
            planes.insert(planes.end(), {box.lo[axis], box.hi[axis]});
        for (const float at : planes) {
            if (!(at > cell.lo[axis] && at < cell.hi[axis]))
                continue;
            Box<float> below = cell, above = cell;
            below.hi[axis] = above.lo[axis] = at;
            double in_below = 0, in_above = 0;
            for (const Box<float> &box : boxes) {
                in_above += box.hi[axis] > at;
                in_below += box.lo[axis] < at;
            }
            const double cost = 1 + (area_of(below) * in_below + area_of(above) * in_above) / area_of(cell);
            if (cost < least) {
                least = cost;
                best = CellCut{axis, at, cost};
            }
        }
    }
    return best;
}

inline constexpr Task task{best_cut};

} // namespace course::exercise
