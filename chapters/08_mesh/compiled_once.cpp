// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/08_mesh/triangle.hpp"

namespace course {

template double plane_t_in_doubt(const Ray<double> &, const Triangle<float> &);

} // namespace course
