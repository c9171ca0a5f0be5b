// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/13_bsp_tree/taught.hpp"
#include "chapters/14_bvh/bvh.hpp"

namespace course {

inline const auto structures_of_14 =
    std::tuple_cat(structures_of_13, std::tuple{Named<MedianBvh>{"bvh-median"}, Named<Bvh>{"bvh"}});

} // namespace course
