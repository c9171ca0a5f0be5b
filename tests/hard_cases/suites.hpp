// Every measurement of the program `accuracy`, one line each.
#pragma once
#include "tests/hard_cases/suite.hpp"

namespace course::hard {

Suite sphere_suite();
Suite plane_suite();
Suite disk_suite();
Suite triangle_suite();
Suite affine_triangle_suite();
Suite box_suite();
Suite cylinder_suite();
Suite cone_suite();
Suite mesh_suite();
Suite parity_suite();
Suite structure_suite();
Suite wide_suite();
Suite spawn_suite();
Suite corner_suite();
Suite optics_suite();

std::vector<Suite> all_suites();

} // namespace course::hard
