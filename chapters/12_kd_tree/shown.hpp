// The heat map of triangles in any structure taught so far: compiled once (shown.cpp), for this chapter's program and
// for the next one's.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "common/rendering.hpp"

#include <functional>
#include <string>
#include <vector>

namespace course {

// Calls f(map) with the triangles in the structure of that name, one of structures_of_12; it lives until f returns.
void with_heat_map(const std::string &structure, const std::vector<Triangle<>> &triangles,
                   const std::function<void(const Renderer &map)> &f);

} // namespace course
