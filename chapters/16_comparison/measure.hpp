// Lesson 16, step 11: one scene, all contestants: build, verify, and let them take turns.
#pragma once
#include "chapters/16_comparison/verify.hpp"
#include "common/timing.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace course {

struct Effort {
    int side = 256, rounds = 5; // side² rays of each kind
    double seconds = 0.06;      // a contestant whose round takes longer gets fewer rays
    double brute_tests = 2e8;   // what brute force may spend on each kind of rays
    int builds = 3;
    double patience = 1;       // a build that takes longer is not repeated
    double longest_build = 60; // one that takes longer is not tried on the next larger scene of a series
    std::uint64_t seed = 1;
    double limits = 1; // the sizes in limits.hpp times this
};
inline Effort quick_effort() { return {128, 3, 0.012, 5e6, 2, 0.05, 0.4, 1, 1}; }
inline Effort brief_effort() { return {96, 2, 0.005, 2e6, 1, 0.05, 0.3, 1, 0.1}; }

template <class Work> double seconds_of(Work &&work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A contestant that has built the scene.
struct Ready {
    const Entrant *entrant;
    std::unique_ptr<Contestant> built;
    double build_seconds;
};

// Builds in rounds as well: the median of each one's times.
inline std::vector<Ready> build_all(const std::vector<Entrant> &entrants, const Triangles &triangles,
                                    const Effort &effort) {
    std::vector<Ready> ready;
    std::vector<std::vector<double>> seconds(entrants.size());
    for (int round = 0; round < effort.builds; ++round)
        for (std::size_t i = 0; i < entrants.size(); ++i) {
            if (round == 0)
                ready.push_back({&entrants[i], nullptr, 0});
            else if (seconds[i][0] > effort.patience)
                continue;
            ready[i].built = nullptr; // its memory first goes back
            seconds[i].push_back(seconds_of([&] { ready[i].built = entrants[i].build(triangles); }));
        }
    for (std::size_t i = 0; i < entrants.size(); ++i) {
        std::ranges::sort(seconds[i]);
        ready[i].build_seconds = seconds[i][seconds[i].size() / 2];
    }
    return ready;
}

// As many rays as the contestant can trace in the time that a round may take, evenly taken from the batch. Who is given
// fewer is slower by the ray, since these have less in common. So a few rays are tried up to three times, and the
// fastest counts: the first time, nothing lies in a cache.
inline Share share_for(const Contestant &contestant, const RayBatch &batch, double seconds) {
    Share few(batch, std::max<std::size_t>(1, batch.rays.size() / 64));
    double least = infinity<double>;
    for (int i = 0; i < 3 && (i == 0 || least < seconds / 8); ++i)
        least = std::min(least, seconds_of([&] { few.trace(contestant, batch.is_shadow()); }));
    const double each = least / static_cast<double>(few.rays.size());
    const double too_many = each * static_cast<double>(batch.rays.size()) / seconds;
    return {batch, static_cast<std::size_t>(std::clamp(too_many, 1.0, static_cast<double>(few.step)))};
}

// The steps of about a thousand of the rays.
inline Counts steps_of_some(const Contestant &contestant, const Share &share, bool shadow, double &rays) {
    std::vector<TestRay> some;
    const std::size_t step = 1 + share.rays.size() / 1024;
    for (std::size_t i = 0; i < share.rays.size() / step; ++i)
        some.push_back(share.rays[place_in_stretch(i, step)]);
    rays = static_cast<double>(some.size());
    return contestant.steps(some, shadow);
}

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The speed of every contestant on one batch, in million rays a second, and how many of its answers were wrong.
struct Result {
    std::size_t rays;
    double mrays_per_s;
    Verdict verdict;
    double nodes, tests; // per ray
};

inline std::vector<Result> race(const std::vector<Ready> &ready, const RayBatch &batch, const Truth &truth,
                                const Effort &effort) {
    std::vector<Share> shares;
    std::vector<std::function<void()>> variants;
    for (const Ready &one : ready)
        shares.push_back(share_for(*one.built, batch, effort.seconds));
    for (std::size_t i = 0; i < ready.size(); ++i)
        variants.push_back([&, i] { shares[i].trace(*ready[i].built, batch.is_shadow()); });
    const std::vector<double> seconds = median_seconds(variants, effort.rounds);

    std::vector<Result> results;
    for (std::size_t i = 0; i < ready.size(); ++i) {
        const Entrant &entrant = *ready[i].entrant;
        Result result{shares[i].rays.size(), static_cast<double>(shares[i].rays.size()) / seconds[i] / 1e6,
                      verdict_on(shares[i], truth, batch.is_shadow(), entrant.exact()), unknown, unknown};
        if (entrant.ours()) {
            double rays;
            const Counts counts = steps_of_some(*ready[i].built, shares[i], batch.is_shadow(), rays);
            result.nodes = static_cast<double>(counts.nodes) / rays;
            result.tests = static_cast<double>(counts.tests) / rays;
        }
        results.push_back(result);
    }
    return results;
}

} // namespace course
