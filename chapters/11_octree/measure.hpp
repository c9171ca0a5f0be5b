// Lesson 11, the experiments: how deep to divide, and what it means that an octree cuts objects in two (claim C5).
#pragma once
#include "common/program.hpp"

namespace course {

// Tables, JSON and a plot: the work per ray against the depth of the tree, and the duplicates in three scenes.
void measure_octree(Program &program, const std::string &mesh_file);

} // namespace course
