#include "chapters/14_bvh/shown.hpp"
#include "chapters/09_aabb/exhibit.hpp"
#include "chapters/09_aabb/heat_map.hpp"
#include "chapters/14_bvh/taught.hpp"

namespace course {

void with_shown(const std::string &structure, const Studio &studio, std::uint64_t seed,
                const std::function<void(const Shown &)> &f) {
    const auto scene = exhibit_in(structures_of_14, structure, studio);
    f({lit_exhibit(scene, studio, seed),
       [&scene](double legend_at) { return heat_map(scene, HeatScale{}, legend_at); }});
}

} // namespace course
