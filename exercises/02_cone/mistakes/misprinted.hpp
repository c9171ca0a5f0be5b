// Mistake: the notes' misprint (A eq. 40): (d · n) stands where its square belongs.
// Caught by: a slanted ray
#pragma once
#include "exercises/02_cone/task.hpp"

#include <cmath>

namespace course::exercise {

inline std::optional<double> cone_hit(const Ray<double> &ray, const Cone<float> &cone) {
    const Vec<double> apex(cone.apex), axis = Vec<double>(cone.base) - apex, n = normalize(axis), m = ray.origin - apex;
    const double radius = static_cast<double>(cone.radius), nn = length(axis);
    const double cos_squared = nn * nn / (nn * nn + radius * radius);
    const double dn = dot(ray.direction, n), mn = dot(m, n);
    const double a = dn - cos_squared * dot(ray.direction, ray.direction);
    const double b = dn * mn - cos_squared * dot(ray.direction, m);
    const double c = mn * mn - cos_squared * dot(m, m);
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0))
        return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)); // where a = 0, q / a lies in no interval
    const double first = q / a, second = c / q;
    for (const double t : {second < first ? second : first, second < first ? first : second}) {
        const double height = mn + t * dn;
        if (height >= 0 && height <= nn && in_range(ray, t))
            return t;
    }
    return {};
}

inline constexpr Task task{cone_hit};

} // namespace course::exercise
