// The structures that take part: all that were taught. A new one enters by its chapter's list.
#pragma once
#include "chapters/15_wide_bvh/taught.hpp"

namespace course {

inline const auto &structures_of_16 = structures_of_15;

} // namespace course
