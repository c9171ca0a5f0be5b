// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/10_uniform_grid/grid.hpp"

namespace course {

template struct Grid<Triangle<>>;

} // namespace course
