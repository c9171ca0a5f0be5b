// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/09_aabb/structure.hpp"

namespace course {

template std::vector<Box<float>> float_boxes(std::span<const Triangle<>>);
template void try_slot(Sheared<Ray<double>> &, const ShapeList<Triangle<>> &, Id, Hit<double> &);
template bool is_hit(const Sheared<Ray<double>> &, const ShapeList<Triangle<>> &, Id);

} // namespace course
