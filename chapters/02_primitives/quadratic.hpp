// Lesson 02, step 4: two roots without cancellation, in ascending order, whatever the sign of a.
#pragma once
#include <array>
#include <cmath>

namespace course {

// The roots of a t² + 2 b t + c = 0. The caller gives the discriminant b² - a c, which must not be negative, because
// each shape knows a way to compute it that does not cancel. Of the two roots (-b ± s) / a one adds numbers of the same
// sign; the other follows from the product of the roots, c / a. Where a = 0 the equation is linear and one of the two
// is infinite or NaN, which no ray's interval contains. Where a < 0 the roots change places; here they are sorted.
inline std::array<double, 2> roots(double a, double b, double c, double discriminant) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    const double first = q / a, second = c / q;
    if (second < first)
        return {second, first};
    return {first, second};
}

} // namespace course
