// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/01_ray_casting/sphere.hpp"

namespace course {

template double t_in_doubt(const Ray<double> &, const Sphere<float> &);

} // namespace course
