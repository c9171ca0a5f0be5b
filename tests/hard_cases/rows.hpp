// The rows of families that count wrong answers, and the rays that a new one starts from.
#pragma once
#include "tests/hard_cases/suite.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace course::hard {

inline Row result_row(const std::string &family, const std::string &test, const std::string &kernel, bool is_default,
                      const std::string &scalar, const std::string &parameter, const Settings &settings) {
    Row row;
    row.set("family", family).set("test", test).set("kernel", kernel).set("default", is_default);
    row.set("scalar", scalar).set("parameter", parameter).set("seed", settings.seed);
    return row;
}

// Sets the counts, and notes in the outcome whether a default row stays within its limit; `also`: what else it must
// have reached.
inline void close_row(Outcome &outcome, Row row, std::uint64_t cases, std::uint64_t wrong, double per_million_allowed,
                      bool is_default, bool also = true) {
    const double per_million = cases ? 1e6 * static_cast<double>(wrong) / static_cast<double>(cases) : 0;
    row.set("cases", cases).set("misclassified", wrong).set("misclassified_per_million", per_million);
    const bool reached = per_million <= per_million_allowed && also;
    if (is_default)
        row.set("reached", reached);
    outcome.passed = outcome.passed && (reached || !is_default);
    outcome.rows.push_back(row);
}

// What became of the rays that were spawned (H11).
struct SpawnTally {
    std::uint64_t spawned = 0, wrong = 0;               // rays
    std::uint64_t acne = 0, leaks = 0, leaks_asked = 0; // of which one ray may count for several
    std::vector<float> offsets;                         // of some of them, in ulps of a float at the largest coordinate

    void add(const SpawnTally &other) {
        spawned += other.spawned;
        wrong += other.wrong;
        acne += other.acne;
        leaks += other.leaks;
        leaks_asked += other.leaks_asked;
        offsets.insert(offsets.end(), other.offsets.begin(), other.offsets.end());
    }
    void note_offset(double ulps) {
        if (offsets.size() < 256)
            offsets.push_back(static_cast<float>(ulps));
    }
};

inline void close_spawn_row(Outcome &outcome, Row row, SpawnTally tally, bool is_default) {
    std::ranges::sort(tally.offsets);
    const double median = tally.offsets.empty() ? 0 : static_cast<double>(tally.offsets[tally.offsets.size() / 2]);
    row.set("acne", tally.acne).set("leaks", tally.leaks).set("leaks_asked", tally.leaks_asked);
    row.set("offset_ulp_median", median);
    close_row(outcome, row, tally.spawned, tally.wrong, 0, is_default, median <= 16);
}

} // namespace course::hard
