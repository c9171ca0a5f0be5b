// The acceleration structures that H6 and H12 run through: all that were taught so far.
#pragma once
#include "chapters/12_kd_tree/taught.hpp"
#include "chapters/14_bvh/taught.hpp"

namespace course::hard {

// A chapter that adds a structure is one more name here, or a newer list that holds them all.
inline const auto all_structures =
    std::tuple_cat(structures_of_12, std::tuple{Named<MedianBvh>{"bvh-median"}, Named<Bvh>{"bvh"}});

template <class Visit> void for_each_structure(Visit visit) {
    std::apply([&](const auto &...one) { (visit(one), ...); }, all_structures);
}

} // namespace course::hard
