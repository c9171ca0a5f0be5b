// The structures that take part: all that were taught. A new one enters by its chapter's list.
#pragma once
#include "chapters/13_bsp_tree/taught.hpp"
#include "chapters/14_bvh/bvh.hpp"

namespace course {

inline const auto structures_of_16 =
    std::tuple_cat(structures_of_13, std::tuple{Named<MedianBvh>{"bvh-median"}, Named<Bvh>{"bvh"}});

} // namespace course
