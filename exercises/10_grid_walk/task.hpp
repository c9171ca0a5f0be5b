// Exercise 10: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "exercises/grading/not_done.hpp"

#include <vector>

namespace course {

// A grid of cubes: cell (i, j, k) reaches from lo + size (i, j, k) to lo + size (i + 1, j + 1, k + 1).
struct SmallGrid {
    Vec<double> lo;
    double size;      // of a cell's edge
    glm::ivec3 count; // of the cells along each axis

    bool has(const glm::ivec3 &cell) const {
        return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < count.x && cell.y < count.y && cell.z < count.z;
    }
};

struct Task {
    std::vector<glm::ivec3> (*cells_along)(const Ray<double> &, const SmallGrid &);
};

} // namespace course
