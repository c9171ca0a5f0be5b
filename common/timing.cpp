#include "common/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace course {

std::vector<double> median_seconds(const std::vector<std::function<void()>> &variants, int rounds) {
    std::vector<std::vector<double>> seconds(variants.size());
    for (int round = -1; round < rounds; ++round)
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const auto start = std::chrono::steady_clock::now();
            variants[i]();
            const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
            if (round >= 0)
                seconds[i].push_back(passed.count());
        }
    std::vector<double> medians;
    for (auto &list : seconds) {
        const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
        std::nth_element(list.begin(), middle, list.end());
        medians.push_back(*middle);
    }
    return medians;
}

} // namespace course
