// Lesson 14, step 1: four numbers at once, and a box made of them.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"

#include <span>
#ifdef __AVX__
#include <immintrin.h>
#endif

namespace course {

// Four numbers that are computed with at once: a type that g++ and clang both know, on every processor. Chapter 15
// goes further that way.
using Four = float __attribute__((vector_size(16)));
using FourInts = int __attribute__((vector_size(16)));

// The numbers of x that stand at these places.
inline Four picked(const Four &x, const FourInts &places) {
#ifdef __AVX__
    return (Four)_mm_permutevar_ps((__m128)x, (__m128i)places);
#else
    return Four{x[places[0]], x[places[1]], x[places[2]], x[places[3]]};
#endif
}

// x y + z, rounded once where the processor can, twice elsewhere: only for bounds that have room for either.
inline Four multiply_add(const Four &x, const Four &y, const Four &z) {
#ifdef __FMA__
    return (Four)_mm_fmadd_ps((__m128)x, (__m128)y, (__m128)z);
#else
    return x * y + z;
#endif
}

// Number by number the larger one; b where a is NaN.
inline Four larger(const Four &a, const Four &b) { return a > b ? a : b; }

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
