// Lesson 06, step 1: the direction in which a mirror sends a ray.
#pragma once
#include "common/vectors.hpp"

namespace course {

// The direction turned over at the surface (A eq. 48), of the same length. The normal has length one; either side of it
// may face the ray. (GLM has reflect() and refract() of its own, hence the longer names here.)
inline Vec<double> mirror_direction(const Vec<double> &direction, const Vec<double> &normal) {
    return direction - 2 * dot(direction, normal) * normal;
}

} // namespace course
