#include "tests/hard_cases/suite.hpp"

#include <algorithm>
#include <cmath>

namespace course::hard {

Threshold threshold_of(const std::string &family, bool quick) {
    if (family == "H5" && !quick)
        return {.misclassified_per_million = 1};
    if (family == "H8")
        return {.false_hits_count = false};
    if (family == "H15")
        return {.t_error_ulp = 4};
    return {};
}

double float_ulps(double t, double exact) {
    if (!std::isfinite(t))
        return infinity<double>;
    const int exponent = std::max(std::ilogb(exact), -126);
    return std::abs(t - exact) / std::ldexp(1.0, exponent - 23);
}

void Tally::judge(const exact::Answer &truth, double t) {
    ++cases;
    const bool hit = t != no_hit;
    if (hit && !(t > 0 && std::isfinite(t))) {
        ++nan;
        ++false_hits;
        return;
    }
    if (hit && !truth.may_hit())
        ++false_hits;
    else if (!hit && !truth.may_miss())
        ++false_misses;
    else if (hit) {
        const double error = float_ulps(t, truth.t);
        t_error_max = std::max(t_error_max, error);
        if (t_errors.size() < 64)
            t_errors.push_back(static_cast<float>(error));
    }
}

void Tally::add(const Tally &other) {
    cases += other.cases;
    false_misses += other.false_misses;
    false_hits += other.false_hits;
    nan += other.nan;
    t_error_max = std::max(t_error_max, other.t_error_max);
    t_errors.insert(t_errors.end(), other.t_errors.begin(), other.t_errors.end());
}

double Tally::t_error_median() const {
    if (t_errors.empty())
        return 0;
    auto sorted = t_errors;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, middle);
    return static_cast<double>(*middle);
}

void append(Outcome &all, Outcome one) {
    all.passed = all.passed && one.passed;
    all.rows.insert(all.rows.end(), one.rows.begin(), one.rows.end());
}

} // namespace course::hard
