// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/11_octree/build.hpp"

namespace course {

template class OctreeBuilder<Triangle<>>;

} // namespace course
