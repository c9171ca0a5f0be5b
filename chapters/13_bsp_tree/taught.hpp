// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/12_kd_tree/taught.hpp"
#include "chapters/13_bsp_tree/bsp.hpp"

namespace course {

inline const auto structures_of_13 = std::tuple_cat(structures_of_12, std::tuple{Named<Bsp>{"bsp"}});

} // namespace course
