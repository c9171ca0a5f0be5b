// Mistake: the plane is taken to be crossed wherever the line crosses it.
// Caught by: a ray that runs away from the plane stays on its side
#pragma once
#include "exercises/13_bsp_sides/task.hpp"

namespace course::exercise {

inline Sides sides_met(const Ray<double> &ray, const CutPlane &plane) {
    const double slope = dot(plane.normal, ray.direction);
    const double begin = dot(plane.normal, point_at(ray, ray.t_min)) - plane.offset;
    const bool above = begin != 0 ? begin > 0 : slope > 0;
    if (slope == 0)
        return {above, false, 0};
    const double change = (plane.offset - dot(plane.normal, ray.origin)) / slope;
    return {above, change < ray.t_max, change};
}

inline constexpr Task task{sides_met};

} // namespace course::exercise
