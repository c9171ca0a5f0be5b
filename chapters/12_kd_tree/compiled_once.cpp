// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/12_kd_tree/kd_tree.hpp"

namespace course {

template class KdBuilder<Triangle<>, MiddleOfCell>;
template class KdBuilder<Triangle<>, MedianOfObjects>;
template class KdBuilder<Triangle<>, LeastCost>;

} // namespace course
