// Exercise 12: what an answer hands over.
#pragma once
#include "chapters/02_primitives/box.hpp"
#include "exercises/grading/not_done.hpp"

#include <optional>
#include <span>
#include <vector>

namespace course {

// A plane across an axis (0, 1, 2 for x, y, z), and the cost of the cell once it is cut there.
struct CellCut {
    int axis;
    float at;
    double cost;
};

// The surface of a box.
inline double area_of(const Box<float> &box) {
    const Vec<double> e = Vec<double>(box.hi) - Vec<double>(box.lo);
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

struct Task {
    std::optional<CellCut> (*best_cut)(std::span<const Box<float>>, const Box<float> &);
};

} // namespace course
