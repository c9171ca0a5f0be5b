// Lesson 07, beside step 1: one sign, worked out without any rounding, for rays at the very edge of total reflection.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

namespace course {

// A sum that is exact: numbers that do not overlap, in ascending order of size (an expansion: Shewchuk 1997, and
// Knuth's error-free sum of two). Each number added makes it one longer at most.
class ExactSum {
  public:
    void add(double term) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double sum = term + terms_[i], part = sum - term;
            const double lost = (term - (sum - part)) + (terms_[i] - part);
            if (lost != 0)
                terms_[kept++] = lost;
            term = sum;
        }
        if (term != 0)
            terms_[kept++] = term;
        count_ = kept;
    }
    // The largest term decides: all the others together are smaller.
    int sign() const {
        const double leading = count_ ? terms_[count_ - 1] : 0;
        return (leading > 0) - (leading < 0);
    }

  private:
    std::array<double, 8> terms_{};
    std::size_t count_ = 0;
};

// The sign of from² - to² - from² cos²: positive where light is totally reflected. The indices are floats in value, so
// their squares have at most 48 digits and are exact; a product of two doubles is the rounded one and what fma() says
// the rounding took off it.
inline int sign_of_excess(double cosine, double from, double to) {
    const double square = cosine * cosine, square_rest = std::fma(cosine, cosine, -square);
    ExactSum sum;
    sum.add(from * from);
    sum.add(-(to * to));
    for (const double part : {square, square_rest}) {
        const double product = from * from * part;
        sum.add(-product);
        sum.add(-std::fma(from * from, part, -product));
    }
    return sum.sign();
}

} // namespace course
