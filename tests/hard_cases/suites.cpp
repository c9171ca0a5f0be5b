#include "tests/hard_cases/suites.hpp"

namespace course::hard {

// A new measurement is one line here.
std::vector<Suite> all_suites() {
    return {sphere_suite(), plane_suite(),    disk_suite(),  triangle_suite(), affine_triangle_suite(),
            box_suite(),    cylinder_suite(), cone_suite(),  mesh_suite(),     structure_suite(),
            parity_suite(), wide_suite(),     spawn_suite(), corner_suite(),   optics_suite()};
}

} // namespace course::hard
