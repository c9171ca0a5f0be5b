// The structures taught so far, by the names that --structure takes.
#pragma once
#include "chapters/09_aabb/accelerate.hpp"
#include "chapters/09_aabb/one_box.hpp"

namespace course {

inline const std::tuple structures_of_09{Named<PlainList>{"none"}, Named<OneBox>{"box"}};

} // namespace course
