// Mistake: the cosine keeps its sign, as in the notes (A eq. 54 to 56): right from outside, wrong from inside.
// Caught by: from behind the normal as well
#pragma once
#include "exercises/07_fresnel/task.hpp"

#include <cmath>

namespace course::exercise {

inline std::optional<Vec<double>> bent(const Vec<double> &direction, const Vec<double> &normal, double n_from,
                                       double n_to) {
    const double along = dot(direction, normal), cos_i = -along, ratio = n_from / n_to;
    const double square = 1 - ratio * ratio * (1 - cos_i * cos_i);
    if (!(square >= 0))
        return {};
    const double change = ratio * cos_i - std::sqrt(square);
    return ratio * direction + change * normal;
}

inline Shares divided(double cos_i, double n_from, double n_to) {
    const double ratio = n_from / n_to, square = 1 - ratio * ratio * (1 - cos_i * cos_i);
    if (!(square > 0))
        return {1, 0};
    const double cos_t = std::sqrt(square);
    const auto divide = [](double a, double b) {
        const double sum = (a + b) * (a + b);
        return Shares{(a - b) * (a - b) / sum, 4 * a * b / sum};
    };
    const Shares across = divide(n_from * cos_i, n_to * cos_t), within = divide(n_to * cos_i, n_from * cos_t);
    return {0.5 * (across.reflected + within.reflected), 0.5 * (across.transmitted + within.transmitted)};
}

inline constexpr Task task{bent, divided};

} // namespace course::exercise
