// Lesson 08, the experiments: what each form of the triangle test costs and loses, and what brute force costs.
#pragma once
#include "common/program.hpp"

namespace course {

// Speed of every form on the same pairs of rays and triangles, and what it loses of rays that start inside a closed
// mesh. Prints a table; writes it, and a plot of speed against loss, beside the picture.
void measure_forms(const Program &program);

// The time that brute force takes for one ray, against the number of triangles, and the slope on logarithmic axes.
void measure_cost(const Program &program);

} // namespace course
