// Lesson 09, the experiments: what bounds cost and save (claim C20), and which rays the printed slab test loses.
#pragma once
#include "chapters/08_mesh/mesh.hpp"
#include "common/program.hpp"

namespace course {

void measure_bounds(const Program &program, const Mesh<> &mesh);
void measure_lost_rays(const Program &program);

} // namespace course
