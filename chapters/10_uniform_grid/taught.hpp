// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/09_aabb/taught.hpp"
#include "chapters/10_uniform_grid/grid.hpp"

namespace course {

inline const auto structures_of_10 = std::tuple_cat(structures_of_09, std::tuple{Named<Grid>{"grid"}});

} // namespace course
