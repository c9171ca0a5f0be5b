// Lesson 15, step 1: eight floats at once. The only header that names a processor's instructions.
#pragma once
#include <bit>
#include <cstdint>
#include <cstring>

#ifdef __AVX2__
#include <immintrin.h>
#endif

// On a processor with narrower registers the compiler cuts these vectors into pieces, and would warn that functions
// hand them over differently there. All these functions vanish into their callers.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace course {

// + - * / and comparisons work on all eight, as chapter 14's Four does. What follows is what no operator says.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(64)));
using Longs = std::int64_t __attribute__((vector_size(64)));
inline constexpr unsigned lanes = 8;

inline Floats all(float x) { return Floats{x, x, x, x, x, x, x, x}; }
inline Ints all_ints(std::int32_t x) { return Ints{x, x, x, x, x, x, x, x}; }

template <class Vector = Floats> Vector load(const void *from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
template <class Vector> void store(void *to, Vector v) { std::memcpy(to, &v, sizeof v); }

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

inline Doubles absolute(Doubles a) { return (Doubles)((Longs)a & INT64_MAX); }
inline Floats absolute(Floats a) { return (Floats)((Ints)a & INT32_MAX); }
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

// A bit for each lane: whether a > b there. Not so where one is NaN.
inline unsigned above(Floats a, Floats b) {
#if defined __AVX512VL__
    return _mm256_cmp_ps_mask((__m256)a, (__m256)b, _CMP_GT_OQ);
#elif defined __AVX2__
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_GT_OQ)));
#else
    const Ints is = a > b;
    unsigned bits = 0;
    for (unsigned i = 0; i < lanes; ++i)
        bits |= static_cast<unsigned>(is[i] & 1) << i;
    return bits;
#endif
}

// A bit for each lane: whether it is negative (-0 is).
inline unsigned signs(Doubles a) {
#if defined __AVX512DQ__
    return _mm512_movepi64_mask((__m512i)a);
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < lanes; ++i)
        bits |= static_cast<unsigned>(((Longs)a)[i] < 0) << i;
    return bits;
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

// A bit for each lane: whether it is odd.
inline unsigned odd(Ints a) {
#if defined __AVX512VL__
    return _mm256_test_epi32_mask((__m256i)a, (__m256i)all_ints(1));
#elif defined __AVX2__
    return static_cast<unsigned>(_mm256_movemask_ps((__m256)(a << 31)));
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < lanes; ++i)
        bits |= static_cast<unsigned>(a[i] & 1) << i;
    return bits;
#endif
}

// The same as permuted() for one bit in place of each lane.
inline unsigned permuted_bits(unsigned bits, Ints by) {
    return odd(all_ints(static_cast<std::int32_t>(bits)) >> (by & 7));
}

// The lanes whose bits are set, moved together to the front.
template <class Vector> Vector compressed(Vector v, unsigned bits) {
#ifdef __AVX512VL__
    return (Vector)_mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), (__m256i)v);
#else
    Vector result{};
    for (unsigned i = 0; bits; bits &= bits - 1)
        result[i++] = v[std::countr_zero(bits)];
    return result;
#endif
}

} // namespace course
