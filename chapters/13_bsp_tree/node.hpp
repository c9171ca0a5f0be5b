// Lesson 13, step 3: a node of 24 bytes.
#pragma once
#include "chapters/13_bsp_tree/polytope.hpp"

#include <cstdint>
#include <stdexcept>

namespace course {

// An inner node holds a plane. The child behind it is the next node; where the child in front is, the node says.
// A leaf has no normal, and keeps the number of its entries in the place of the offset.
class BspNode {
  public:
    BspNode() = default;
    static BspNode leaf(std::size_t first_entry, std::size_t count) {
        return {{{}, static_cast<double>(count)}, first_entry};
    }
    static BspNode inner(const SplitPlane &plane, std::size_t front) { return {plane, front}; }

    bool is_leaf() const { return normal_ == Vec<float>(0); }
    std::uint32_t first() const { return next_; } // entry of a leaf
    std::uint32_t end() const { return next_ + static_cast<std::uint32_t>(offset_); }
    std::uint32_t front() const { return next_; } // child of an inner node
    SplitPlane plane() const { return {normal_, offset_}; }

  private:
    BspNode(const SplitPlane &plane, std::size_t next)
        : normal_(plane.normal), next_(static_cast<std::uint32_t>(next)), offset_(plane.offset) {
        if (next > 0xffffffff)
            throw std::length_error("more nodes or entries than a BSP-tree can number");
    }

    Vec<float> normal_{0};
    std::uint32_t next_ = 0;
    double offset_ = 0;
};
static_assert(sizeof(BspNode) == 24);

} // namespace course
