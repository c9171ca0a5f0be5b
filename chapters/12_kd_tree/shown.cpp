#include "chapters/12_kd_tree/shown.hpp"
#include "chapters/09_aabb/any_structure.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/12_kd_tree/taught.hpp"

namespace course {

void with_heat_map(const std::string &structure, const std::vector<Triangle<>> &triangles,
                   const std::function<void(const Renderer &map)> &f) {
    const Scene scene(std::vector{any_structure(structures_of_12, structure, triangles)});
    f(heat_map(scene, HeatScale{}));
}

} // namespace course
