// Lesson 08: a closed mesh of as many triangles as wanted, for experiments: a sphere out of an icosahedron.
#pragma once
#include "chapters/08_mesh/mesh.hpp"

namespace course {

// 20 · 4^level triangles around the origin with corners at the given distance, wound counter-clockwise from outside.
Mesh<> ball(int level, float radius = 1);

} // namespace course
