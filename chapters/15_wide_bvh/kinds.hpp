// Lesson 15, the second experiment: which way suits which kind of rays, and what a second core brings.
#pragma once
#include "chapters/09_aabb/exhibit.hpp"
#include "common/program.hpp"

namespace course {

// Renders the exhibit with light that has bounced once; traces its rays of each kind in every way, and the picture in
// one way and by kind, on one core and on all. Prints two tables, and writes them.
void measure_kinds(const Program &program, const Studio &studio);

} // namespace course
