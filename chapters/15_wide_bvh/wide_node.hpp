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

// Three doubles and one that is not used.
using Doubles4 = double __attribute__((vector_size(32)));
using Floats4 = float __attribute__((vector_size(16)));

// Chapter 14's NodeRay for eight boxes.
class WideRay {
  public:
    // `pad` is a multiple of the derived one.
    template <class T, class S> [[gnu::always_inline]] WideRay(const Ray<T> &ray, const Box<S> &reach, float pad = 1) {
        const Doubles4 origin = four(ray.origin), direction = four(ray.direction), size = absolute(direction);
        const Doubles4 place = absolute(origin);
        scale_ = largest(size);
        t_min_ = static_cast<float>(static_cast<double>(ray.t_min) * scale_) * (1 - 0x1p-22f);

        const double margin = static_cast<double>(pad) * (sizeof(T) == sizeof(float) ? 0x1p-19 : 0x1p-21) *
                              (largest(place) + largest_coordinate(reach));
        const Doubles4 least = Doubles4{} + 0x1p-30 * scale_;
        const Doubles4 along = size > least ? size : least, inverse = turned(scale_ / along, direction);
        const Doubles4 shift = Doubles4{} + margin, ahead = turned(shift, direction);
        const Floats4 slope = __builtin_convertvector(inverse, Floats4);
        const Floats4 near = __builtin_convertvector(-(origin + ahead) * inverse, Floats4);
        const Floats4 far = __builtin_convertvector(-(origin - ahead) * inverse, Floats4);
        for (int axis = 0; axis < 3; ++axis) {
            inverse_[axis] = slope[axis];
            near_shift_[axis] = near[axis];
            far_shift_[axis] = far[axis];
        }
        octant_ = 0;
        for (unsigned i = 0; i < 3; ++i) {
            const unsigned backwards = std::signbit(ray.direction[static_cast<int>(i)]);
            near_[i] = lanes * (2 * i + backwards);
            far_[i] = lanes * (2 * i + 1 - backwards);
            octant_ |= backwards << i;
        }
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
        const float *planes = node.planes[0][0];
        Floats near[3], far[3];
        for (unsigned i = 0; i < 3; ++i) {
            near[i] = fused(load(planes + near_[i]), all(inverse_[i]), all(near_shift_[i]));
            far[i] = fused(load(planes + far_[i]), all(inverse_[i]), all(far_shift_[i]));
        }
        const Floats enter = larger(larger(near[0], near[1]), larger(near[2], all(t_min_)));
        const Floats exit = smaller(smaller(far[0], far[1]), smaller(far[2], all(t_max)));
        return {enter, ~above(enter, exit) & 255};
    }

  private:
    template <class T> static Doubles4 four(const Vec<T> &v) {
        return Doubles4{static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z), 0};
    }
    using Bits4 = std::int64_t __attribute__((vector_size(32)));
    static Doubles4 absolute(Doubles4 a) { return (Doubles4)((Bits4)a & INT64_MAX); }
    static Doubles4 turned(Doubles4 a, Doubles4 by) { return (Doubles4)((Bits4)a | ((Bits4)by & INT64_MIN)); }
    static double largest(Doubles4 a) { return std::max({a[0], a[1], a[2]}); }

    double scale_;
    float t_min_;
    unsigned near_[3], far_[3], octant_; // where the planes of each axis lie in a node
    float inverse_[3], near_shift_[3], far_shift_[3];
};

} // namespace course
