// Mistake: a ray that begins in the plane is said to be below, wherever it goes.
// Caught by: a ray that begins in the plane visits the side it goes to
#pragma once
#include "exercises/13_bsp_sides/task.hpp"

namespace course::exercise {

inline Sides sides_met(const Ray<double> &ray, const CutPlane &plane) {
    const double slope = dot(plane.normal, ray.direction);
    const double begin = dot(plane.normal, point_at(ray, ray.t_min)) - plane.offset;
    const bool above = begin > 0;
    if (above ? slope >= 0 : slope <= 0 || begin == 0) // it never comes to the plane
        return {above, false, 0};
    const double change = (plane.offset - dot(plane.normal, ray.origin)) / slope;
    return {above, change < ray.t_max, change};
}

inline constexpr Task task{sides_met};

} // namespace course::exercise
