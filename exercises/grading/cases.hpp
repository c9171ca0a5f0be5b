// Random cases for grading tests.
#pragma once
#include "common/random.hpp"
#include "common/vectors.hpp"

namespace course {

// A point of the cube from -size to size.
inline Vec<double> any_point(Random &random, double size) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

// A direction of length one, any as likely as another.
inline Vec<double> any_direction(Random &random) {
    for (;;) {
        const Vec<double> v = any_point(random, 1);
        if (const double square = dot(v, v); square > 0.01 && square < 1)
            return normalize(v);
    }
}

} // namespace course
