// Lesson 10, step 2: where the cells of a grid are, and how many of them.
#pragma once
#include "chapters/10_uniform_grid/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace course {

// The edge of cubes of which about `cells` fill a box of this size. A direction in which the box is thinner than a cube
// takes no part in the reckoning: a flat scene gets squares, one along a line gets pieces of that line.
inline double edge_of_cells(const Vec<double> &size, double cells) {
    std::array<double, 3> e{size.x, size.y, size.z};
    std::ranges::sort(e);
    if (const double edge = std::cbrt(e[0] * e[1] * e[2] / cells); edge <= e[0])
        return edge;
    if (const double edge = std::sqrt(e[1] * e[2] / cells); edge <= e[1])
        return edge;
    return e[2] / cells;
}

// Equal cells, count.x * count.y * count.z of them, from the corner `lo` on.
struct Lattice {
    Vec<double> lo{0}, cell{1};
    glm::ivec3 count{1};
    double margin = 0; // by how much a cell is wider for those who look what is in it than for those who walk by

    // Around the box with room for twice the margin, so that not even rounding leads out of the lattice a ray that
    // meets something at the rim. No cell is so small that the margin would count.
    Lattice(const Box<float> &box, double cells) {
        if (!holds_any(box))
            return;
        margin = std::max(0x1p-20 * largest_coordinate(box), 0x1p-126);
        lo = Vec<double>(box.lo) - 2 * margin;
        const Vec<double> size = extent(box) + 4 * margin;
        const double edge = std::max(edge_of_cells(size, std::max(cells, 1.0)), 8 * margin);
        for (int axis = 0; axis < 3; ++axis) {
            count[axis] = static_cast<int>(std::max(1.0, std::round(size[axis] / edge)));
            cell[axis] = size[axis] / count[axis];
        }
    }

    double cells() const { return static_cast<double>(count.x) * count.y * count.z; }

    // The cell that holds the point, or the nearest one to a point outside; the first for NaN.
    glm::ivec3 cell_at(const Vec<double> &point) const {
        glm::ivec3 at(0);
        for (int axis = 0; axis < 3; ++axis)
            if (const double place = (point[axis] - lo[axis]) / cell[axis]; place > 0)
                at[axis] = static_cast<int>(std::min(place, count[axis] - 1.0));
        return at;
    }

    // The box around the cells from `first` to `last`.
    Box<double> box_of(const glm::ivec3 &first, const glm::ivec3 &last) const {
        return {lo + Vec<double>(first) * cell, lo + Vec<double>(last + 1) * cell};
    }
    Box<double> box() const { return box_of({0, 0, 0}, count - 1); }

    // Into how many cells shapes fall, on average over all places where the lattice might begin. A cell meets a shape
    // exactly if its corner lies in the shape swept along the cell, and the volume of that is a sum: of the cell's own,
    // of each width of the shape times the cell's opposite face, of each shadow times the cell's opposite edge, and of
    // the shape's own. Divided by the cell's volume:
    double expected_entries(double shapes, const Footprint &sum) const {
        const Vec<double> by_shadow = sum.shadows * cell / (cell.x * cell.y * cell.z);
        const Vec<double> by_width = sum.widths / cell;
        return shapes + by_width.x + by_width.y + by_width.z + by_shadow.x + by_shadow.y + by_shadow.z +
               sum.volume / (cell.x * cell.y * cell.z);
    }
};

} // namespace course
