// Lesson 14, step 2: a node of 64 bytes, and the test of its two boxes.
#pragma once
#include "chapters/09_aabb/slab.hpp"
#include "chapters/14_bvh/four.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace course {

// Where a child is: a range of primitives, or, with none in it, another node.
struct Link {
    Id first; // the first primitive's slot, or the node's number
    Id count; // primitives in the leaf; 0 for a node

    bool is_leaf() const { return count != 0; }
};

// A node keeps the boxes of its two children, not its own: a visit reads one cache line and decides about both. The
// planes lie by axis, then low or high, then child, so that the two near planes of an axis are neighbours.
struct alignas(64) Node {
    float planes[3][2][2];
    Link children[2];

    void set(std::size_t child, const Four &lo, const Four &hi, Link link) {
        for (int axis = 0; axis < 3; ++axis) {
            planes[axis][0][child] = lo[axis];
            planes[axis][1][child] = hi[axis];
        }
        children[child] = link;
    }
};
static_assert(sizeof(Node) == 64);

// SlabRay for nodes, in float: the same two rays a margin apart, with a margin that also covers the rounding of every
// float operation here (at most 4 of 2^-24 each; the margin is 2^-21). Distances are scaled by the direction's largest
// component, so that no direction is too short or too long for float.
class NodeRay {
  public:
    template <class T, class S> NodeRay(const Ray<T> &ray, const Box<S> &reach) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction), place = abs(origin);
        const double largest = std::max({size.x, size.y, size.z});
        const double margin = (sizeof(T) == sizeof(float) ? 0x1p-19 : 0x1p-21) *
                              (std::max({place.x, place.y, place.z}) + largest_coordinate(reach));
        scale_ = largest;
        t_min_ = rounded_outwards_down(static_cast<double>(ray.t_min));
        const double least = 0x1p-30 * largest;
        prepare(0, origin.x, std::copysign(std::max(size.x, least), direction.x), margin);
        prepare(1, origin.y, std::copysign(std::max(size.y, least), direction.y), margin);
        prepare(2, origin.z, std::copysign(std::max(size.z, least), direction.z), margin);
    }

    // A t of the ray as this class counts it, rounded up.
    float scaled(double t) const { return static_cast<float>(t * scale_) * (1 + 0x1p-23f); }

    // When the ray enters each child's box, and whether it meets it by t_max.
    struct Entries {
        float enter[2];
        bool meets[2];
    };

    // What a walk has found so far, as the test below wants it. To be made anew when t_max has changed.
    Four limit(float t_max) const { return Four{t_min_, t_min_, -t_max, -t_max}; }

    // The four distances of an axis at once: to both near planes, and to both far planes with the sign turned round, so
    // that "the latest entry" and "the earliest exit" are both a maximum, and one operation on four does for all.
    Entries operator()(const Node &node, const Four &limit) const {
        Four t[3];
        for (int axis = 0; axis < 3; ++axis) {
            Four planes;
            std::memcpy(&planes, node.planes[axis], sizeof planes);
            t[axis] = multiply_add(picked(planes, near_first_[axis]), inverse_[axis], shift_[axis]);
        }
        const Four latest = larger(larger(t[0], t[1]), larger(t[2], limit));
        return {{latest[0], latest[1]}, {!(latest[0] > -latest[2]), !(latest[1] > -latest[3])}};
    }

  private:
    void prepare(int axis, double origin, double direction, double margin) {
        const double inverse = scale_ / direction, shift = std::copysign(margin, direction);
        const auto i = static_cast<float>(inverse);
        const auto near = static_cast<float>((origin + shift) * inverse);
        const auto far = static_cast<float>((origin - shift) * inverse);
        near_first_[axis] = std::signbit(direction) ? FourInts{2, 3, 0, 1} : FourInts{0, 1, 2, 3};
        inverse_[axis] = Four{i, i, -i, -i};
        shift_[axis] = Four{-near, -near, far, far};
    }
    float rounded_outwards_down(double t) const { return static_cast<float>(t * scale_) * (1 - 0x1p-23f); }

    double scale_;
    float t_min_;
    FourInts near_first_[3]; // where in a node the near planes of the children are, and the far ones
    Four inverse_[3], shift_[3];
};

} // namespace course
