// Lesson 01, step 6: what shading needs to know about the hit that won.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"

namespace course {

// A surface interaction. The point lies on the shape as closely as T can say; the normal has length one and points
// outwards (for flat shapes: to the side from which the winding is counter-clockwise), whichever side the ray came
// from. Later chapters ask the shape for more: its texture coordinates, its bounds, the offset of a bounced ray.
template <class T, class Shape> struct Surface {
    Vec<T> point, normal;
    const Shape &shape;
    Id id = 0; // which primitive of the shape, where the shape is a container
};

} // namespace course
