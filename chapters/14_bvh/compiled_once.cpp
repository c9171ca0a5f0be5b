// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/14_bvh/build.hpp"

namespace course {

template class TreeBuilder<BinnedSah>;
template class TreeBuilder<LongestAxisMedian>;

} // namespace course
