// The acceleration structures that H6 and H12 run through: all that were taught so far.
#pragma once
#include "chapters/15_wide_bvh/taught.hpp"

namespace course::hard {

// A chapter that adds a structure brings a newer list, which is named here.
inline const auto &all_structures = structures_of_15;

inline constexpr std::size_t structure_count = std::tuple_size_v<std::remove_cvref_t<decltype(all_structures)>>;

template <class Visit> void for_each_structure(Visit visit) {
    std::apply([&](const auto &...one) { (visit(one), ...); }, all_structures);
}

} // namespace course::hard
