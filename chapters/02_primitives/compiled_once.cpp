// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/box.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/02_primitives/plane.hpp"

namespace course {

template double t_in_doubt(const Ray<double> &, const Plane<float> &);
template double t_in_doubt(const Ray<double> &, const Disk<float> &);
template double t_in_doubt(const Ray<double> &, const AffineTriangle<float> &);
template double t_in_doubt(const Ray<double> &, const Cylinder<float> &);
template double t_in_doubt(const Ray<double> &, const Cone<float> &);
template double t_in_doubt(const Ray<double> &, const Box<float> &);

} // namespace course
