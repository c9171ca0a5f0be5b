// Lesson 12, step 1: a node of 8 bytes.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"

#include <bit>
#include <cstdint>

namespace course {

// A plane across an axis, or a leaf. Two bits say which: 0, 1 and 2 are axes, 3 is a leaf. Nodes lie in the order of a
// walk that goes to the lower child first, so only the upper child's place must be stored. Boxes are not stored at all:
// a walk knows from where it came.
class KdNode {
  public:
    static KdNode cut(int axis, float at, std::uint32_t upper) {
        return {std::bit_cast<std::uint32_t>(at), upper << 2 | static_cast<std::uint32_t>(axis)};
    }
    static KdNode leaf(std::uint32_t first, std::uint32_t count) { return {first, count << 2 | 3}; }

    bool is_leaf() const { return (rest_ & 3) == 3; }
    int axis() const { return static_cast<int>(rest_ & 3); }  // of a cut
    float at() const { return std::bit_cast<float>(value_); } // of a cut: where on the axis
    std::uint32_t upper() const { return rest_ >> 2; }        // of a cut: the number of the upper child
    std::uint32_t first() const { return value_; }            // of a leaf: where its list begins
    std::uint32_t count() const { return rest_ >> 2; }        // of a leaf: how long it is

  private:
    KdNode(std::uint32_t value, std::uint32_t rest) : value_(value), rest_(rest) {}

    std::uint32_t value_, rest_;
};
static_assert(sizeof(KdNode) == 8);

} // namespace course
