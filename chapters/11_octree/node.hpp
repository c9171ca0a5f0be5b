// Lesson 11, step 1: cubes, their eight halves of halves of halves, and a node of eight bytes.
#pragma once
#include "chapters/09_aabb/bounds.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>

namespace course {

struct Cube {
    Vec<double> lo{0};
    double edge = 0;

    // Octant 0 to 7: bit 0 says that it is the upper half in x, bit 1 in y, bit 2 in z.
    Cube octant(unsigned which) const {
        const double half = 0.5 * edge;
        return {lo + half * Vec<double>(which & 1, which >> 1 & 1, which >> 2), half};
    }

    // The cube's box with a rim: for those who ask what lies in it.
    Box<double> box(double rim) const { return {lo - rim, lo + (edge + rim)}; }
};

// By how much rounding may move a shape against a cube. Far more than a double's rounding, far less than any cell.
inline double rim_around(const Box<float> &box) { return std::max(0x1p-40 * largest_coordinate(box), 0x1p-130); }

// The smallest cube with a rim around the box, from the box's lower corner on: what is flat lies at the cube's border
// and not in its middle, where every halving would cut along it.
inline Cube cube_around(const Box<float> &box) {
    if (!holds_any(box))
        return {};
    const Vec<double> e = extent(box);
    const double rim = rim_around(box);
    return {Vec<double>(box.lo) - rim, std::max({e.x, e.y, e.z}) + 2 * rim};
}

// Eight bytes: of the eight children only those that hold something exist, side by side, and eight bits say which.
class OctreeNode {
  public:
    static OctreeNode leaf(std::size_t first_entry, std::size_t count) {
        if (first_entry > 0xffffffff || count > 0xffffff)
            throw std::length_error("more entries than an octree can number");
        return {first_entry, static_cast<std::uint32_t>(count) << 8};
    }
    static OctreeNode inner(std::size_t first_child, unsigned octants) {
        if (first_child > 0xffffffff)
            throw std::length_error("more nodes than an octree can number");
        return {first_child, octants};
    }
    OctreeNode() = default;

    bool is_leaf() const { return octants() == 0; }
    std::uint32_t first() const { return first_; } // entry of a leaf
    std::uint32_t count() const { return bits_ >> 8; }
    unsigned octants() const { return bits_ & 0xff; }

    // The number of the child in an octant: that of the first one, and one more for each that exists before it.
    std::uint32_t child(unsigned octant) const {
        return first_ + static_cast<std::uint32_t>(std::popcount(octants() & ((1u << octant) - 1)));
    }

  private:
    OctreeNode(std::size_t first, std::uint32_t bits) : first_(static_cast<std::uint32_t>(first)), bits_(bits) {}

    std::uint32_t first_ = 0, bits_ = 0;
};
static_assert(sizeof(OctreeNode) == 8);

} // namespace course
