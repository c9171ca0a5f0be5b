// Mistake: the cosine without its sign: the lamp shines through the surface from behind.
// Caught by: a surface turned away stays dark
#pragma once
#include "exercises/03_point_light/task.hpp"

#include <cmath>

namespace course::exercise {

inline Colour lamp_light(const Vec<double> &point, const Vec<double> &normal, const Lamp &lamp,
                         const Blocked &blocked) {
    const Vec<double> to_lamp = lamp.position - point;
    const double square = dot(to_lamp, to_lamp), distance = std::sqrt(square);
    const Vec<double> direction = to_lamp / distance;
    const double cosine = std::abs(dot(direction, normal));
    if (!(cosine > 0) || blocked({point, direction, 0, distance}))
        return Colour(0);
    return static_cast<float>(cosine / square) * lamp.intensity;
}

inline constexpr Task task{lamp_light};

} // namespace course::exercise
