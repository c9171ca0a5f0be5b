// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/10_uniform_grid/taught.hpp"
#include "chapters/11_octree/octree.hpp"

namespace course {

inline const auto structures_of_11 = std::tuple_cat(structures_of_10, std::tuple{Named<Octree>{"octree"}});

} // namespace course
