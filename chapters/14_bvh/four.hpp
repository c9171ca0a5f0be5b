// Lesson 14, step 1: four numbers at once, and a box made of them.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"

#include <cstring>
#include <span>

namespace course {

// Four numbers that are computed with at once: a type that g++ and clang both know, on every processor. Chapter 15
// goes further that way.
using Four = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));

// Two floats from each of two places. They are fetched as doubles, for which processors have the right instruction.
inline Four four_of(const float (&a)[2], const float (&b)[2]) {
    using Two = double __attribute__((vector_size(16)));
    double first, second;
    std::memcpy(&first, a, sizeof first);
    std::memcpy(&second, b, sizeof second);
    return (Four)(Two{first, second});
}

// A box whose fourth coordinate is not used.
struct Box4 {
    Four lo, hi;

    static Box4 empty() { return {Four{} + infinity<float>, Four{} - infinity<float>}; }

    void include(const Box4 &other) {
        lo = other.lo < lo ? other.lo : lo;
        hi = other.hi > hi ? other.hi : hi;
    }
    // Half the surface area, by which the boxes of one cut compare like by the whole.
    float half_area() const {
        const Four e = hi - lo;
        return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
    }
    // Halved first, lest the sum overflow.
    Four middle() const { return 0.5f * lo + 0.5f * hi; }
};

} // namespace course
