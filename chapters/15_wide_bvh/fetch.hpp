// Lesson 15, step 7: asking memory for what will soon be looked at.
#pragma once
#include "chapters/15_wide_bvh/wide_bvh.hpp"

namespace course {

// Has the node or the leaf that the link names brought near, while other work goes on. No branch: whether it is a node
// or a leaf is as hard to guess as where the ray goes.
template <WideOptions Options> void fetch(const WideBvhBy<Triangle<float>, Options> &bvh, WideLink link) {
    const unsigned is_leaf = link.is_leaf();
    const char *const first[] = {reinterpret_cast<const char *>(bvh.tree.nodes.data()),
                                 reinterpret_cast<const char *>(bvh.shapes.leaves().data())};
    constexpr std::size_t size[] = {sizeof(WideNode), sizeof(TriangleLeaf)};
    const char *const place = first[is_leaf] + link.first() * size[is_leaf];
    for (std::size_t line = 0; line < std::max(size[0], size[1]) / 64; ++line)
        __builtin_prefetch(place + 64 * line);
}

} // namespace course
