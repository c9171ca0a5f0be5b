// Lesson 15, step 7: asking memory for what will soon be looked at.
#pragma once
#include "chapters/15_wide_bvh/wide_bvh.hpp"

namespace course {

// Has the node or the leaf that a link names brought near, while other work goes on. No branch: whether it is a node or
// a leaf is as hard to guess as where the ray goes.
template <WideOptions Options> class Fetch {
  public:
    explicit Fetch(const WideBvhBy<Triangle<float>, Options> &bvh)
        : first_{reinterpret_cast<const char *>(bvh.tree.nodes.data()),
                 reinterpret_cast<const char *>(bvh.shapes.leaves().data())} {}

    void operator()(WideLink link) const {
        constexpr std::size_t node = sizeof(WideNode), leaf = sizeof(typename PackedTriangles<Options>::Leaf);
        const std::size_t is_leaf = link.is_leaf();
        const char *const place = first_[is_leaf] + link.first() * (node + is_leaf * (leaf - node));
        for (std::size_t line = 0; line < std::max(node, leaf); line += 64)
            __builtin_prefetch(place + line);
    }

  private:
    const char *first_[2]; // node, leaf
};

} // namespace course
