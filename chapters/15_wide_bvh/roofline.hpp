// Lesson 15, the experiment: how fast the processor could be, and how fast the walk is.
#pragma once
#include "chapters/09_aabb/exhibit.hpp"
#include "common/program.hpp"

namespace course {

// Measures a step at a node and at a leaf, each alone and each waiting for the one before, and what memory takes to
// answer; and holds the time of real rays against the sum of their steps. Prints a table, and writes it.
void measure_roofline(const Program &program, const Studio &studio);

} // namespace course
