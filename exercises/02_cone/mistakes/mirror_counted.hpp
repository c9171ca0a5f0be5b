// Mistake: squaring has added a second cone on the other side of the apex, and it is taken for a part of the first:
// heights from -|n|² to |n|² are let through. Caught by: the mirror image is not met
#pragma once
#include "exercises/02_cone/task.hpp"

#include <cmath>

namespace course::exercise {

inline std::optional<double> cone_hit(const Ray<double> &ray, const Cone<float> &cone) {
    const Vec<double> apex(cone.apex), n = Vec<double>(cone.base) - apex, m = ray.origin - apex;
    const double radius = static_cast<double>(cone.radius), nn = dot(n, n), slope = radius * radius / nn;
    const double dn = dot(ray.direction, n), mn = dot(m, n);
    const Vec<double> dxn = cross(ray.direction, n), mxn = cross(m, n);
    const double a = dot(dxn, dxn) - slope * dn * dn;
    const double b = dot(dxn, mxn) - slope * dn * mn;
    const double c = dot(mxn, mxn) - slope * mn * mn;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0))
        return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)); // where a = 0, q / a lies in no interval
    const double first = q / a, second = c / q;
    for (const double t : {second < first ? second : first, second < first ? first : second}) {
        const double height = mn + t * dn;
        if (std::abs(height) <= nn && in_range(ray, t))
            return t;
    }
    return {};
}

inline constexpr Task task{cone_hit};

} // namespace course::exercise
