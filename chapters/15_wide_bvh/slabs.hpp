// Lesson 15, step 2b: the test of eight boxes at once.
#pragma once
#include "chapters/15_wide_bvh/wide_node.hpp"

#include <array>
#include <cstddef>
#include <type_traits>

namespace course {

inline Floats in_all_lanes(float x) { return all(x); }
inline Floats in_all_lanes(Floats x) { return x; }

// Where the planes of each axis lie in a node, those that a ray meets first and those that it meets last, for each
// octant: bit i of its number says that the ray runs backwards along axis i.
struct Sides {
    std::size_t near[3], far[3];
};
inline constexpr auto sides_of_octants = [] {
    std::array<Sides, 8> all;
    for (unsigned octant = 0; octant < 8; ++octant)
        for (unsigned axis = 0; axis < 3; ++axis) {
            const unsigned back = octant >> axis & 1;
            all[octant].near[axis] = lanes * (2 * axis + back);
            all[octant].far[axis] = lanes * (2 * axis + 1 - back);
        }
    return all;
}();

// What boxes have to know of a ray. A plane at x is met at x * inverse + shift, where the shift holds a margin: boxes
// are entered earlier and left later. A ray that is put away between its steps keeps each number once, as a float; one
// that walks from end to end keeps it in all lanes, as Floats.
template <class Number> struct Slabs {
    alignas(16) alignas(Number) Number inverse[4], near_shift[4], far_shift[4]; // by axis; the fourth is not used
    Number t_min;
    unsigned octant;
    const Sides *sides;

    Slabs() = default;
    explicit Slabs(const Slabs<float> &other) requires(!std::is_same_v<Number, float>)
        : t_min(all(other.t_min)), octant(other.octant), sides(other.sides) {
        for (const auto i : {0, 1, 2}) {
            inverse[i] = all(other.inverse[i]);
            near_shift[i] = all(other.near_shift[i]);
            far_shift[i] = all(other.far_shift[i]);
        }
    }

    // When the ray enters each child's box, and when it leaves it or reaches t_max: it meets the box if not before.
    struct Entries {
        Floats enter, exit;
        unsigned met() const { return at_most((Ints)enter, (Ints)exit); } // a bit for each box
    };
    [[gnu::always_inline]] Entries operator()(const WideNode &node, float t_max) const {
        const float *const planes = node.planes[0][0];
        const auto &[near, far] = *sides;
        Floats first[3], last[3];
        for (const auto i : {0, 1, 2}) {
            const Floats slope = in_all_lanes(inverse[i]);
            first[i] = fused(load(planes + near[i]), slope, in_all_lanes(near_shift[i]));
            last[i] = fused(load(planes + far[i]), slope, in_all_lanes(far_shift[i]));
        }
        const Floats enter = later(later(first[0], first[1]), later(first[2], in_all_lanes(t_min)));
        const Floats exit = sooner(sooner(last[0], last[1]), sooner(last[2], all(t_max)));
        return {enter, exit};
    }
};

} // namespace course
