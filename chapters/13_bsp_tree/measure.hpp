// Lesson 13, the experiments: which planes are worth it (claim C6), and how the classical tree degenerates.
#pragma once
#include "chapters/13_bsp_tree/choose.hpp"
#include "common/program.hpp"

namespace course {

// Plates one over the other, all tilted alike: no plane at right angles to an axis passes between them.
std::vector<Triangle<>> tilted_plates();

// Tables, JSON and a plot.
void measure_bsp(Program &program, const std::string &mesh_file);

} // namespace course
