// Lesson 15, step 1b: from lanes to bits, one for each, and back.
#pragma once
#include "chapters/15_wide_bvh/lanes.hpp"

#include <bit>
#include <cmath>
#include <utility>

namespace course {

// A bit for each lane: whether it is odd, as -1 is, which a comparison gives where it holds.
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

// A bit for each lane: whether a > b there. Not so where one is NaN.
inline unsigned above(Floats a, Floats b) {
#if defined __AVX512VL__
    return _mm256_cmp_ps_mask((__m256)a, (__m256)b, _CMP_GT_OQ);
#elif defined __AVX2__
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_GT_OQ)));
#else
    return odd(a > b);
#endif
}

// A bit for each lane: whether a <= b there.
inline unsigned at_most(Ints a, Ints b) {
#if defined __AVX512VL__
    return _mm256_cmple_epi32_mask((__m256i)a, (__m256i)b);
#elif defined __AVX2__
    return static_cast<unsigned>(_mm256_movemask_ps((__m256)(a > b))) ^ 255;
#else
    return odd(a <= b);
#endif
}

// A bit for each number: whether it is negative (-0 is).
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
inline unsigned signs(Triple64 a) {
#ifdef __AVX__
    return static_cast<unsigned>(_mm256_movemask_pd((__m256d)a)) & 7;
#else
    const auto bit = [&](int i) { return static_cast<unsigned>(std::signbit(a[i])) << i; };
    return bit(0) | bit(1) | bit(2);
#endif
}

// A bit for each of three comparisons: whether it holds.
inline unsigned holding(TripleLongs comparisons) { return signs((Triple64)comparisons); }

// The number of the lowest bit that is set; there must be one.
inline unsigned lowest(unsigned bits) { return static_cast<unsigned>(__builtin_ctz(bits)); }

// The same as permuted() for one bit in place of each lane.
inline unsigned permuted_bits(unsigned bits, Ints by) {
    return odd(all_ints(static_cast<std::int32_t>(bits)) >> (by & 7));
}

// The lanes whose bits are set, moved together to the front.
template <class Vector> Vector compressed(Vector v, unsigned bits) {
#if defined __AVX512VL__
    return (Vector)_mm256_maskz_compress_epi32(static_cast<__mmask8>(bits), (__m256i)v);
#elif defined __AVX2__ && defined __BMI2__
    const auto bytes = _pdep_u64(bits, 0x0101010101010101) * 255; // all of the byte where there was a bit
    const auto chosen = static_cast<long long>(_pext_u64(0x0706050403020100, bytes));
    return permuted(v, (Ints)_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(chosen)));
#else
    Vector result{};
    for (unsigned i = 0; bits; bits &= bits - 1)
        result[i++] = v[lowest(bits)];
    return result;
#endif
}

// The smallest and the largest of the eight: each is held against others in three rounds.
inline std::pair<float, float> range(Floats of) {
    Floats low = of, high = of;
    for (const Ints other :
         {Ints{4, 5, 6, 7, 0, 1, 2, 3}, Ints{2, 3, 0, 1, 6, 7, 4, 5}, Ints{1, 0, 3, 2, 5, 4, 7, 6}}) {
        low = smaller(low, permuted(low, other));
        high = larger(high, permuted(high, other));
    }
    return {float{low[0]}, float{high[0]}};
}

// The same of those lanes whose bits are set, at least one.
inline std::pair<float, float> range(Floats of, unsigned bits) {
    const Ints chosen = (all_ints(static_cast<std::int32_t>(bits)) >> Ints{0, 1, 2, 3, 4, 5, 6, 7} & 1) != 0;
    return range(chosen ? of : all(of[lowest(bits)]));
}

} // namespace course
