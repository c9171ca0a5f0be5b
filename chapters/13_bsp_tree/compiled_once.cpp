// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/13_bsp_tree/build.hpp"

namespace course {

template class BspBuilder<Triangle<>>;

} // namespace course
