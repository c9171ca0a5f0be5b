// Lesson 15, step 2: a node with eight children.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"
#include "chapters/15_wide_bvh/lane_bits.hpp"

namespace course {

// Where a child is, in 32 bits: the number of a node, or a leaf's place and how many primitives it holds.
class WideLink {
  public:
    static constexpr Id most = Id{1} << 28;

    static WideLink node(Id number) { return WideLink(number << 4); }
    static WideLink leaf(Id first, Id count) { return WideLink(first << 4 | count); }

    static WideLink end() { return WideLink(15); } // nothing waits any more

    WideLink() = default;
    bool is_leaf() const { return count() != 0; }
    bool is_end() const { return count() == 15; }
    Id count() const { return bits_ & 15; } // 1 to 8; 0 for a node
    Id first() const { return bits_ >> 4; } // the leaf's first slot or its block, or the node's number

  private:
    explicit WideLink(Id bits) : bits_(bits) {}
    Id bits_;
};

// Four cache lines. Children that are not there have boxes that no ray meets.
struct alignas(64) WideNode {
    float planes[3][2][lanes]; // by axis, low or high, child
    WideLink links[lanes];
    std::uint32_t far_first[8]; // for rays of each octant: the children from far to near, three bits for each
};
static_assert(sizeof(WideNode) == 256);

inline constexpr unsigned all_children = (1 << lanes) - 1; // a bit for each

// Three bits each, spread over the lanes.
inline Ints unpacked(std::uint32_t threes) {
    const auto all_of_them = all_ints(static_cast<std::int32_t>(threes));
    return all_of_them >> Ints{0, 3, 6, 9, 12, 15, 18, 21};
}

} // namespace course
