// Mistake: the nearest root in the interval is chosen first, and its height looked at afterwards. Where it belongs to
// the mirror image, the cone behind it vanishes. Caught by: the mirror image hides nothing
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
    for (const double t : {second < first ? second : first, second < first ? first : second})
        if (in_range(ray, t)) {
            const double height = mn + t * dn;
            if (height >= 0 && height <= nn)
                return t;
            return {};
        }
    return {};
}

inline constexpr Task task{cone_hit};

} // namespace course::exercise
