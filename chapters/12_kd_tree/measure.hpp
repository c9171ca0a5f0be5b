// Lesson 12, the experiment: three rules of cutting beside the grid, and what objects in several leaves cost.
#pragma once
#include "common/program.hpp"

namespace course {

// Table and JSON of size and work for three scenes.
void measure_trees(Program &program, const std::string &mesh_file);

} // namespace course
