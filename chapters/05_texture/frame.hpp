// Lesson 05, step 1: a frame around an axis, because a texture needs to know where "right" and "up" are.
#pragma once
#include "common/vectors.hpp"

#include <cmath>

namespace course {

// Three directions of length one at right angles, e0 x e1 = e2.
struct Frame {
    Vec<double> e0, e1, e2;
};

// The frame whose e2 is the axis (of any length but zero). Somebody who stands in front of the surface with this normal
// sees e0 point to the right and e1 upwards (+y); where the axis is vertical, e0 is +x. Note A leaves e0 to be chosen
// (3.1.6 to 3.1.9): this is the choice, the same for every shape.
inline Frame frame_around(const Vec<double> &axis) {
    const Vec<double> e2 = normalize(axis);
    const double horizontal = std::sqrt(axis.x * axis.x + axis.z * axis.z);
    const Vec<double> e0 = horizontal > 0 ? Vec<double>(axis.z, 0, -axis.x) / horizontal : Vec<double>(1, 0, 0);
    return {e0, cross(e2, e0), e2};
}

} // namespace course
