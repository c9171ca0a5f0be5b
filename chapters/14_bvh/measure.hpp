// Lesson 14, the experiments: what a rule costs to build and brings to the rays, how long a median takes, and what a
// second core helps.
#pragma once
#include "chapters/09_aabb/exhibit.hpp"
#include "common/program.hpp"

namespace course {

void measure_rules(const Program &program, const Studio &studio);
void measure_median(const Program &program);
void measure_cores(const Program &program);

} // namespace course
