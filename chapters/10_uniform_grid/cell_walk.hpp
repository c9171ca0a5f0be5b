// Lesson 10, step 4: from cell to cell along a ray (3D-DDA; Amanatides and Woo 1987).
#pragma once
#include "chapters/10_uniform_grid/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// For each axis it knows at which t the ray reaches the next plane between cells; the smallest of the three says where
// the ray goes next. Where two are equal the ray passes through an edge, and the walk goes diagonally: the margin of
// the lattice has put whatever touches the edge into both of the cells that it does visit.
class CellWalk {
  public:
    // From the cell of the ray's point at `t`, or from the nearest one. No coordinate of the ray's origin may be more
    // than 2^10 times those of the lattice: see is_far().
    template <class T> CellWalk(const Ray<T> &ray, const Lattice &lattice, double t) : count_(lattice.count) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction);
        const double largest = std::max({size.x, size.y, size.z});
        at_ = lattice.cell_at(origin + t * direction);
        for (int axis = 0; axis < 3; ++axis) {
            // So slow a component moves the ray by less than the margin while it crosses the lattice. Its planes are
            // never reached; and if all other planes are never reached either, the step leads out of the lattice.
            if (!(size[axis] > 0x1p-40 * largest)) {
                next_[axis] = per_cell_[axis] = infinity<double>;
                step_[axis] = count_[axis];
                continue;
            }
            const bool forwards = direction[axis] > 0;
            const double plane = lattice.lo[axis] + (at_[axis] + (forwards ? 1 : 0)) * lattice.cell[axis];
            next_[axis] = (plane - origin[axis]) / direction[axis];
            per_cell_[axis] = lattice.cell[axis] / size[axis];
            step_[axis] = forwards ? 1 : -1;
        }
    }

    const glm::ivec3 &cell() const { return at_; }

    // The t at which the ray leaves the cell.
    double leaves() const { return std::min({next_[0], next_[1], next_[2]}); }

    // On to the next cell. False where the ray leaves the lattice.
    bool step() {
        const double t = leaves();
        bool within = true;
        for (int axis = 0; axis < 3; ++axis) { // without branches, for no processor can guess which axis is next
            const bool moves = next_[axis] == t;
            at_[axis] += moves ? step_[axis] : 0;
            next_[axis] += moves ? per_cell_[axis] : 0;
            within &= static_cast<unsigned>(at_[axis]) < static_cast<unsigned>(count_[axis]);
        }
        return within;
    }

  private:
    glm::ivec3 at_, count_, step_;
    Vec<double> next_, per_cell_;
};

// Whether the origin is so far away that rounding, here or in an intersect(), may reach beyond the margin. What is seen
// from so far is smaller than a thousandth of its distance, so few rays ever meet it.
template <class T> bool is_far(const Ray<T> &ray, const Lattice &lattice) {
    const Vec<double> o = abs(Vec<double>(ray.origin));
    return std::max({o.x, o.y, o.z}) > 0x1p+10 * largest_coordinate(lattice.box());
}

} // namespace course
