// Lesson 15, step 2: a node with eight children, and the test of their eight boxes at once.
#pragma once
#include "chapters/09_aabb/slab.hpp"
#include "chapters/15_wide_bvh/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace course {

// Where a child is, in 32 bits: the number of a node, or a leaf's place and how many primitives it holds.
class WideLink {
  public:
    static constexpr Id most = Id{1} << 28;

    static WideLink node(Id number) { return WideLink(number << 4); }
    static WideLink leaf(Id first, Id count) { return WideLink(first << 4 | count); }

    WideLink() = default;
    bool is_leaf() const { return count() != 0; }
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

// Three bits each, spread over the lanes.
inline Ints unpacked(std::uint32_t threes) {
    const auto all_of_them = all_ints(static_cast<std::int32_t>(threes));
    return all_of_them >> Ints{0, 3, 6, 9, 12, 15, 18, 21};
}

// Chapter 14's NodeRay for eight boxes.
class WideRay {
  public:
    // `pad` is a multiple of the derived one.
    template <class T, class S> WideRay(const Ray<T> &ray, const Box<S> &reach, float pad = 1) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction), place = abs(origin);
        scale_ = std::max({size.x, size.y, size.z});
        const double margin = static_cast<double>(pad) * (sizeof(T) == sizeof(float) ? 0x1p-19 : 0x1p-21) *
                              (std::max({place.x, place.y, place.z}) + largest_coordinate(reach));
        t_min_ = all(static_cast<float>(static_cast<double>(ray.t_min) * scale_) * (1 - 0x1p-22f));
        const double least = 0x1p-30 * scale_;
        for (int i = 0; i < 3; ++i) {
            const double along = std::copysign(std::max(size[i], least), direction[i]);
            const double inverse = scale_ / along, shift = std::copysign(margin, along);
            inverse_[i] = all(static_cast<float>(inverse));
            near_shift_[i] = all(-static_cast<float>((origin[i] + shift) * inverse));
            far_shift_[i] = all(-static_cast<float>((origin[i] - shift) * inverse));
            near_side_[i] = std::signbit(along);
        }
        octant_ = near_side_[0] | near_side_[1] << 1 | near_side_[2] << 2;
    }

    // A t of the ray as this class counts it, rounded up.
    float scaled(double t) const { return static_cast<float>(t * scale_) * (1 + 0x1p-22f); }

    unsigned octant() const { return octant_; }

    // When the ray enters each child's box, and which of the boxes it meets by t_max: a bit for each.
    struct Entries {
        Floats enter;
        unsigned met;
    };
    Entries operator()(const WideNode &node, float t_max) const {
        Floats enter = t_min_, exit = all(t_max);
        for (unsigned i = 0; i < 3; ++i) {
            const Floats near = load(node.planes[i][near_side_[i]]), far = load(node.planes[i][1 - near_side_[i]]);
            enter = larger(fused(near, inverse_[i], near_shift_[i]), enter);
            exit = smaller(fused(far, inverse_[i], far_shift_[i]), exit);
        }
        return {enter, ~above(enter, exit) & 255};
    }

  private:
    double scale_;
    unsigned near_side_[3], octant_;
    Floats t_min_, inverse_[3], near_shift_[3], far_shift_[3];
};

} // namespace course
