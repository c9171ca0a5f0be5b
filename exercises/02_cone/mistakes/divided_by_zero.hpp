// Mistake: both roots are divided by a. For a ray along the side a is 0, and the one solution of the linear equation is
// lost. Caught by: a ray along the side: the equation is linear
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
    const double root = std::copysign(std::sqrt(discriminant), a), first = (-b - root) / a, second = (-b + root) / a;
    for (const double t : {second < first ? second : first, second < first ? first : second}) {
        const double height = mn + t * dn;
        if (height >= 0 && height <= nn && in_range(ray, t))
            return t;
    }
    return {};
}

inline constexpr Task task{cone_hit};

} // namespace course::exercise
