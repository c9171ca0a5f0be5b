// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/14_bvh/taught.hpp"
#include "chapters/15_wide_bvh/wide_bvh.hpp"

namespace course {

inline const auto structures_of_15 = std::tuple_cat(structures_of_14, std::tuple{Named<WideBvh>{"wide"}});

} // namespace course
