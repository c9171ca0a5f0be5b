// What many programs use, compiled once for all of them. (The headers are whole without it: see CMakeLists.txt.)
#include "chapters/15_wide_bvh/wide_bvh.hpp"

namespace course {

template TriangleList<TriangleLeaf>::TriangleList(std::span<const Triangle<float>>, WideTree &);
template TriangleList<CompactLeaf>::TriangleList(std::span<const Triangle<float>>, WideTree &);
template struct WideBvhBy<Triangle<>>;

} // namespace course
