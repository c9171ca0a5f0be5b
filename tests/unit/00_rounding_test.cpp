// What every proof in the course takes for granted of the compiler: a number that is rounded to float is rounded. g++
// 12 breaks it when it packs several such conversions into a vector, unless told not to (see CMakeLists.txt).
#include <gtest/gtest.h>

#include <array>

namespace {

template <std::size_t N> using Numbers = std::array<double, N>;

template <std::size_t N> [[gnu::noinline]] Numbers<N> rounded_in_place(const Numbers<N> &numbers) {
    Numbers<N> result;
    for (std::size_t i = 0; i < N; ++i)
        result[i] = static_cast<double>(static_cast<float>(numbers[i]));
    return result;
}

template <std::size_t N> [[gnu::noinline]] Numbers<N> rounded_through_an_array(const Numbers<N> &numbers) {
    std::array<float, N> stored;
    for (std::size_t i = 0; i < N; ++i)
        stored[i] = static_cast<float>(numbers[i]);
    Numbers<N> result;
    for (std::size_t i = 0; i < N; ++i)
        result[i] = static_cast<double>(stored[i]);
    return result;
}

template <std::size_t N> void expect_rounding() {
    Numbers<N> numbers;
    for (std::size_t i = 0; i < N; ++i)
        numbers[i] = 0.1 + static_cast<double>(i);
    for (const auto &results : {rounded_in_place(numbers), rounded_through_an_array(numbers)})
        for (std::size_t i = 0; i < N; ++i) {
            const volatile float rounded = static_cast<float>(numbers[i]);
            EXPECT_EQ(results[i], static_cast<double>(rounded)) << i << " of " << N;
        }
}

TEST(Rounding, ToFloatIsNotOptimisedAway) {
    expect_rounding<2>();
    expect_rounding<3>();
    expect_rounding<4>();
    expect_rounding<6>();
    expect_rounding<8>();
    expect_rounding<9>();
}

} // namespace
