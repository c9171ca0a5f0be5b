// Lesson 15, step 1: eight floats at once. Beside chapter 14's four.hpp, this header and lane_bits.hpp are the only
// ones that name a processor's instructions.
#pragma once
#include <cstdint>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#endif

// On a processor with narrower registers the compiler cuts these vectors into pieces. All these functions vanish into
// their callers.

namespace course {

// + - * / and comparisons work on all eight, as chapter 14's Four does. What follows is what no operator says.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(64)));
using Longs = std::int64_t __attribute__((vector_size(64)));
inline constexpr unsigned lanes = 8;

// Three numbers at once, x, y and z or the corners of a triangle, and a fourth that nobody looks at.
using Triple64 = double __attribute__((vector_size(32)));
using Triple32 = float __attribute__((vector_size(16)));
using TripleInts = std::int32_t __attribute__((vector_size(16)));
using TripleLongs = std::int64_t __attribute__((vector_size(32)));

inline Floats all(float x) { return Floats{x, x, x, x, x, x, x, x}; }
inline Ints all_ints(std::int32_t x) { return Ints{x, x, x, x, x, x, x, x}; }

template <class Vector = Floats> Vector load(const void *from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
template <class Vector> void store(void *to, Vector v) { std::memcpy(to, &v, sizeof v); }

// Makes the compiler fetch these numbers from memory, where spreading one over all lanes costs nothing.
template <class Numbers> void keep_in_memory(Numbers &numbers) { asm("" : "+m"(numbers)); }
// Makes the compiler fetch this number by itself: a wide fetch waits long for what was stored in pieces just before.
inline double fetched_alone(double x) {
#ifdef __SSE2__
    asm("" : "+x"(x));
#endif
    return x;
}

// a b + c, rounded once where the processor can, twice elsewhere: only for what has room for either.
inline Floats fused(Floats a, Floats b, Floats c) {
#ifdef __FMA__
    return (Floats)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
#else
    return a * b + c;
#endif
}

// The larger and the smaller of each pair; b where one is NaN.
inline Floats larger(Floats a, Floats b) {
#ifdef __AVX2__
    return (Floats)_mm256_max_ps((__m256)a, (__m256)b);
#else
    return a > b ? a : b;
#endif
}
inline Floats smaller(Floats a, Floats b) {
#ifdef __AVX2__
    return (Floats)_mm256_min_ps((__m256)a, (__m256)b);
#else
    return a < b ? a : b;
#endif
}

// The same by their bits, which order numbers from 0 on as the numbers themselves, and put those below 0 before them. A
// processor compares integers three cycles sooner than floats.
inline Floats later(Floats a, Floats b) { return (Floats)((Ints)a > (Ints)b ? (Ints)a : (Ints)b); }
inline Floats sooner(Floats a, Floats b) { return (Floats)((Ints)a < (Ints)b ? (Ints)a : (Ints)b); }

inline Floats absolute(Floats a) { return (Floats)((Ints)a & INT32_MAX); }
inline Doubles absolute(Doubles a) { return (Doubles)((Longs)a & INT64_MAX); }
inline Triple64 absolute(Triple64 a) { return (Triple64)((TripleLongs)a & INT64_MAX); }
inline Triple32 absolute(Triple32 a) { return (Triple32)((TripleInts)a & INT32_MAX); }
// With the sign turned around where `by` is negative.
inline Floats turned(Floats a, Floats by) { return (Floats)((Ints)a ^ ((Ints)by & INT32_MIN)); }
// The larger of the absolute values.
inline Floats larger_size(Floats a, Floats b) {
#ifdef __AVX512VL__
    return (Floats)_mm256_range_ps((__m256)a, (__m256)b, 0b1011);
#else
    return larger(absolute(a), absolute(b));
#endif
}

// Lane i of the result is lane by[i] (its lowest three bits) of v.
template <class Vector> Vector permuted(Vector v, Ints by) {
#ifdef __AVX2__
    return (Vector)_mm256_permutevar8x32_epi32((__m256i)v, (__m256i)by);
#else
    Vector result;
    for (unsigned i = 0; i < lanes; ++i)
        result[i] = v[by[i] & 7];
    return result;
#endif
}

inline Triple64 widened(Triple32 a) {
#ifdef __AVX__
    return (Triple64)_mm256_cvtps_pd((__m128)a); // g++ 12 makes two halves of __builtin_convertvector
#else
    return __builtin_convertvector(a, Triple64);
#endif
}
inline Triple32 narrowed(Triple64 a) { return __builtin_convertvector(a, Triple32); }
// x, y, z in another order, or two of them twice.
inline Triple64 yzx(Triple64 a) { return __builtin_shufflevector(a, a, 1, 2, 0, 3); }
inline Triple64 zxy(Triple64 a) { return __builtin_shufflevector(a, a, 2, 0, 1, 3); }
inline Triple64 xyx(Triple64 a) { return __builtin_shufflevector(a, a, 0, 1, 0, 3); }
inline Triple64 yzz(Triple64 a) { return __builtin_shufflevector(a, a, 1, 2, 2, 3); }

} // namespace course
