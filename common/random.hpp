// Random numbers that depend on nothing but a seed and a position, so that a picture is the same on any number of
// threads: PCG32 (O'Neill 2014), started from a hash of what it is for.
#pragma once
#include <cstdint>

namespace course {

class Random {
  public:
    // One stream per (seed, index): index is the pixel, or the number of the case.
    explicit Random(std::uint64_t seed, std::uint64_t index = 0)
        : increment_((mix(index + 0x9e3779b97f4a7c15u) << 1) | 1) {
        bits();
        state_ += mix(seed);
        bits();
    }

    std::uint32_t bits() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }

    // Uniform in [0, 1), a multiple of 2^-32.
    double uniform() { return bits() * 0x1p-32; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }

  private:
    // The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
    static std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    std::uint64_t state_ = 0, increment_;
};

} // namespace course
