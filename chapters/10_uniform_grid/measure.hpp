// Lesson 10, the experiments: how many cells are right (B §4 says 27 for each object), and for which scenes.
#pragma once
#include "common/program.hpp"

namespace course {

// Table, JSON and plot of the work and the time per ray against the number of cells, for three scenes.
void measure_cells(Program &program, const std::string &mesh_file);

} // namespace course
