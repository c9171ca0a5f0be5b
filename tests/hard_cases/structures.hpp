// The acceleration structures that H6 and H12 run through: the newest chapter's list of all that were taught so far.
#pragma once
#include "chapters/09_aabb/taught.hpp"

namespace course::hard {

// A chapter that adds a structure changes these two names.
inline const auto &all_structures = structures_of_09;

template <class Visit> void for_each_structure(Visit visit) {
    std::apply([&](const auto &...one) { (visit(one), ...); }, all_structures);
}

} // namespace course::hard
