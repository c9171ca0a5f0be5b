// Lesson 12, step 1: a node of 8 bytes.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"

#include <bit>
#include <cstdint>

namespace course {

// A plane across an axis, a leaf, or a box. Two bits say which: 0, 1 and 2 are axes, 3 is one of the others. Nodes lie
// in the order of a walk that goes to the lower child first, so only the upper child's place must be stored. Cells are
// not stored at all: a walk knows from where it came. Only where a cell is mostly air, a box says where the rest is. It
// takes the room of four nodes, itself and its sides on each axis, and what is in it comes right behind.
class KdNode {
  public:
    static KdNode cut(int axis, float at, std::uint32_t upper) {
        return {std::bit_cast<std::uint32_t>(at), upper << 2 | static_cast<std::uint32_t>(axis)};
    }
    static KdNode leaf(std::uint32_t first, std::uint32_t count) { return {first, count << 2 | 3}; }
    static KdNode box() { return {0, ~std::uint32_t{0}}; } // no leaf is so long
    static KdNode sides(float lo, float hi) {
        return {std::bit_cast<std::uint32_t>(lo), std::bit_cast<std::uint32_t>(hi)};
    }
    static constexpr std::uint32_t box_size = 4;

    bool is_cut() const { return (words_[1] & 3) != 3; }
    bool is_box() const { return words_[1] == ~std::uint32_t{0}; }
    bool is_leaf() const { return !is_cut() && !is_box(); }
    int axis() const { return static_cast<int>(words_[1] & 3); } // of a cut
    float at() const { return std::bit_cast<float>(words_[0]); } // of a cut: where on the axis
    std::uint32_t upper() const { return words_[1] >> 2; }       // of a cut: the number of the upper child
    std::uint32_t first() const { return words_[0]; }            // of a leaf: where its list begins
    std::uint32_t count() const { return words_[1] >> 2; }       // of a leaf: how long it is
    float side(bool high) const { return std::bit_cast<float>(words_[high]); } // of a box, on one axis

  private:
    KdNode(std::uint32_t first, std::uint32_t second) : words_{first, second} {}

    std::uint32_t words_[2];
};
static_assert(sizeof(KdNode) == 8);

} // namespace course
