#include "common/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace course {

std::vector<std::vector<double>> seconds_of_rounds(const std::vector<std::function<void()>> &variants, int rounds) {
    std::vector<std::vector<double>> seconds(variants.size());
    for (int round = -1; round < rounds; ++round)
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const auto start = std::chrono::steady_clock::now();
            variants[i]();
            const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
            if (round >= 0)
                seconds[i].push_back(passed.count());
        }
    return seconds;
}

double quantile(std::vector<double> list, double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(list.size()));
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(std::min(place, list.size() - 1));
    std::nth_element(list.begin(), at, list.end());
    return *at;
}

std::vector<double> median_seconds(const std::vector<std::function<void()>> &variants, int rounds) {
    std::vector<double> medians;
    for (const auto &list : seconds_of_rounds(variants, rounds))
        medians.push_back(quantile(list, 0.5));
    return medians;
}

} // namespace course
