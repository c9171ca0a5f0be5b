// Mistake: the first side is that of the origin, not of where the ray begins to count.
// Caught by: the ray's interval is all that counts
#pragma once
#include "exercises/13_bsp_sides/task.hpp"

namespace course::exercise {

inline Sides sides_met(const Ray<double> &ray, const CutPlane &plane) {
    const double slope = dot(plane.normal, ray.direction);
    const double begin = dot(plane.normal, ray.origin) - plane.offset;
    const bool above = begin != 0 ? begin > 0 : slope > 0;
    if (above ? slope >= 0 : slope <= 0) // it never comes to the plane
        return {above, false, 0};
    const double change = (plane.offset - dot(plane.normal, ray.origin)) / slope;
    return {above, change < ray.t_max, change};
}

inline constexpr Task task{sides_met};

} // namespace course::exercise
