// Mistake: Fresnel's form with sines and tangents of the two angles. At normal incidence it is 0 / 0.
// Caught by: straight on: both angles are 0
#pragma once
#include "exercises/07_fresnel/task.hpp"

#include <cmath>

namespace course::exercise {

inline std::optional<Vec<double>> bent(const Vec<double> &direction, const Vec<double> &normal, double n_from,
                                       double n_to) {
    const double along = dot(direction, normal), cos_i = std::abs(along), ratio = n_from / n_to;
    const double square = 1 - ratio * ratio * (1 - cos_i * cos_i);
    if (!(square >= 0))
        return {};
    const double change = ratio * cos_i - std::sqrt(square);
    return ratio * direction + (along < 0 ? change : -change) * normal;
}

inline Shares divided(double cos_i, double n_from, double n_to) {
    const double sin_t = n_from / n_to * std::sqrt(1 - cos_i * cos_i);
    if (sin_t >= 1)
        return {1, 0};
    const double i = std::acos(cos_i), t = std::asin(sin_t);
    const double across = std::sin(i - t) / std::sin(i + t), within = std::tan(i - t) / std::tan(i + t);
    const double reflected = 0.5 * (across * across + within * within);
    return {reflected, 1 - reflected};
}

inline constexpr Task task{bent, divided};

} // namespace course::exercise
