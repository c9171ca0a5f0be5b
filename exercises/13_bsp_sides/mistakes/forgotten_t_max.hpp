// Mistake: the other side is visited also where the ray ends before it.
// Caught by: the ray's interval is all that counts
#pragma once
#include "exercises/13_bsp_sides/task.hpp"

namespace course::exercise {

inline Sides sides_met(const Ray<double> &ray, const CutPlane &plane) {
    const double slope = dot(plane.normal, ray.direction);
    const double begin = dot(plane.normal, point_at(ray, ray.t_min)) - plane.offset;
    const bool above = begin != 0 ? begin > 0 : slope > 0;
    if (above ? slope >= 0 : slope <= 0) // it never comes to the plane
        return {above, false, 0};
    const double change = (plane.offset - dot(plane.normal, ray.origin)) / slope;
    return {above, true, change};
}

inline constexpr Task task{sides_met};

} // namespace course::exercise
