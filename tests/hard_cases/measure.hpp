// Runs a primitive's cells: makes the cases, asks the oracle once for each, and judges every kernel.
#pragma once
#include "common/errors.hpp"
#include "common/parallel.hpp"
#include "common/timing.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/reader.hpp"
#include "tests/hard_cases/shader_rows.hpp"
#include "tests/hard_cases/suite.hpp"
#include "tests/oracle/shapes.hpp"

#include <array>
#include <bit>
#include <map>
#include <mutex>

namespace course::hard {

inline constexpr std::size_t batch_size = 4096;

// Every (family, parameter, test) draws from a stream of its own, whichever other cells are run.
inline std::uint64_t stream_of(const std::string &text, std::uint64_t seed) {
    std::uint64_t hash = 0xcbf29ce484222325u ^ seed;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

template <class Shape, class Make>
Batch<Shape> make_batch(const Make &make, std::uint64_t stream, std::size_t first, std::size_t count) {
    Batch<Shape> batch;
    for (std::size_t i = first; i < first + count; ++i) {
        Random random(stream, i);
        batch.add(make(random));
    }
    return batch;
}

// One cell: a tally per kernel, in their order. A kernel that cannot take the cell's rays keeps an empty one.
template <class Shape> std::vector<Tally> judge_cell(const Primitive<Shape> &primitive, const Cell<Shape> &cell,
                                                     const Settings &settings, std::size_t cases) {
    std::vector<Tally> tallies(primitive.kernels.size());
    std::mutex adding;
    const std::uint64_t stream = stream_of(primitive.test + cell.family + cell.parameter, settings.seed);
    parallel_for((cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
        const std::size_t first = chunk * batch_size;
        const auto batch = make_batch<Shape>(cell.make, stream, first, std::min(batch_size, cases - first));
        std::vector<exact::Answer> truth;
        for (std::size_t i = 0; i < batch.size(); ++i)
            truth.push_back(exact::answer(batch.rays[i], batch.shapes[i]));
        std::vector<double> t(batch.size());
        for (std::size_t k = 0; k < tallies.size(); ++k) {
            if (cell.double_rays && primitive.kernels[k].scalar != "double")
                continue;
            primitive.kernels[k].run(batch, t);
            Tally tally;
            for (std::size_t i = 0; i < t.size(); ++i)
                tally.judge(truth[i], t[i]);
            const std::lock_guard lock(adding);
            tallies[k].add(tally);
        }
    });
    return tallies;
}

// Whether kernel k, over all of a primitive's cells together, is wrong no more often than the kernel that it is held
// against, beyond what chance explains (three deviations of a count), and never with a NaN.
template <class Shape> bool matches_its_peer(const std::vector<Kernel<Shape>> &kernels,
                                             const std::vector<std::vector<Tally>> &cells, std::size_t k) {
    std::uint64_t own = 0, of_peer = 0, nan = 0;
    for (const std::vector<Tally> &tallies : cells) {
        own += tallies[k].false_misses + tallies[k].false_hits;
        nan += tallies[k].nan;
        for (std::size_t peer = 0; peer < kernels.size(); ++peer)
            if (kernels[peer].name == kernels[k].no_worse_than && kernels[peer].scalar == "float" &&
                tallies[k].cases > 0)
                of_peer += tallies[peer].false_misses + tallies[peer].false_hits;
    }
    const auto expected = static_cast<double>(of_peer);
    return nan == 0 && static_cast<double>(own) <= expected + 3 * std::sqrt(expected + 1);
}

struct Timing {
    double nanoseconds = 0, hit_share = 0;
};

// The time per test of every kernel on the same batch, in turns in one process.
template <class Shape>
std::vector<Timing> time_kernels(const Primitive<Shape> &primitive, const Batch<Shape> &batch, int rounds) {
    std::vector<double> t(batch.size());
    std::vector<std::function<void()>> variants;
    for (const auto &kernel : primitive.kernels)
        variants.push_back([&] {
            kernel.run(batch, t);
            keep(t.data());
        });
    std::vector<Timing> timings;
    for (const double seconds : median_seconds(variants, rounds))
        timings.push_back({1e9 * seconds / static_cast<double>(batch.size()), 0});
    for (std::size_t k = 0; k < timings.size(); ++k) {
        variants[k]();
        if (const auto &seconds = primitive.kernels[k].seconds)
            timings[k].nanoseconds = 1e9 * seconds(batch, t, rounds) / static_cast<double>(batch.size());
        const auto hits = static_cast<double>(t.size() - static_cast<std::size_t>(std::ranges::count(t, no_hit)));
        timings[k].hit_share = hits / static_cast<double>(t.size());
    }
    return timings;
}

template <class Shape> Outcome measure(const Primitive<Shape> &primitive, const Settings &settings) {
    const auto easy = make_batch<Shape>(primitive.random, stream_of(primitive.test, settings.seed), 0, batch_size);
    const auto usual = time_kernels(primitive, easy, settings.timing_rounds);

    // The hard rays of a family, a few from each cell, for the time that they take.
    std::map<std::string, Batch<Shape>> hard_rays;
    std::map<std::string, std::size_t> cells_of;
    for (const auto &cell : primitive.cells)
        ++cells_of[cell.family];
    for (const auto &cell : primitive.cells)
        if (settings.wants(cell.family))
            for (std::size_t i = 0; i < batch_size / cells_of[cell.family]; ++i) {
                Random random(stream_of(cell.parameter, settings.seed), i);
                hard_rays[cell.family].add(cell.make(random));
            }
    std::map<std::string, std::vector<Timing>> on_hard;
    for (const auto &[family, batch] : hard_rays)
        on_hard[family] = time_kernels(primitive, batch, settings.timing_rounds);

    std::vector<std::vector<Tally>> judged;
    for (const auto &cell : primitive.cells)
        if (settings.wants(cell.family)) {
            judged.push_back(judge_cell(primitive, cell, settings, settings.cases));
            settings.done(0.6 / static_cast<double>(primitive.cells.size())); // the rest is H14's
        }
    Outcome outcome;
    std::size_t next = 0;
    for (const auto &cell : primitive.cells) {
        if (!settings.wants(cell.family))
            continue;
        const auto &tallies = judged[next++];
        const Threshold threshold = threshold_of(cell.family, settings.quick);
        for (std::size_t k = 0; k < tallies.size(); ++k) {
            const Tally &tally = tallies[k];
            const auto &kernel = primitive.kernels[k];
            if (tally.cases == 0)
                continue;
            const auto wrong = tally.false_misses + tally.false_hits;
            const auto counted = tally.false_misses + (threshold.false_hits_count ? tally.false_hits : tally.nan);
            const double per_million = 1e6 * static_cast<double>(wrong) / static_cast<double>(tally.cases);
            const bool held_to_a_peer = !kernel.no_worse_than.empty(), asked = kernel.is_default || held_to_a_peer;
            const bool within = 1e6 * static_cast<double>(counted) <=
                                    threshold.misclassified_per_million * static_cast<double>(tally.cases) &&
                                tally.t_error_max <= threshold.t_error_ulp;
            const bool reached = held_to_a_peer ? matches_its_peer(primitive.kernels, judged, k) : within;
            Row row;
            row.set("family", cell.family).set("test", primitive.test).set("kernel", kernel.name);
            row.set("default", kernel.is_default).set("scalar", kernel.scalar).set("parameter", cell.parameter);
            row.set("seed", settings.seed).set("cases", tally.cases).set("misclassified", wrong);
            row.set("misclassified_per_million", per_million);
            row.set("false_misses", tally.false_misses).set("false_hits", tally.false_hits);
            row.set("t_error_ulp_median", tally.t_error_median()).set("t_error_ulp_max", tally.t_error_max);
            row.set("nan", tally.nan).set("ns_per_test", usual[k].nanoseconds);
            row.set("hit_share", usual[k].hit_share);
            row.set("ns_per_test_hard", on_hard[cell.family][k].nanoseconds);
            row.set("hit_share_hard", on_hard[cell.family][k].hit_share);
            if (asked)
                row.set("reached", reached);
            outcome.rows.push_back(row);
            outcome.passed = outcome.passed && (reached || !asked);
        }
    }
    return outcome;
}

// ---- H14 -----------------------------------------------------------------------------------------------------------

// Numbers that nobody wants to meet, in every field: whatever comes, a reported hit has a finite t in the ray's range.
inline float nasty(Random &random) {
    using Limits = std::numeric_limits<float>;
    static constexpr std::array numbers{0.0f,
                                        -0.0f,
                                        1.0f,
                                        -1.0f,
                                        1e20f,
                                        -1e20f,
                                        1e-20f,
                                        Limits::max(),
                                        Limits::denorm_min(),
                                        -Limits::min(),
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        Limits::quiet_NaN()};
    const std::uint32_t pick = random.bits() % 24;
    return pick < numbers.size() ? numbers[pick] : static_cast<float>(random.uniform(-2, 2));
}

template <class Shape> Case<Shape> degenerate_case(Random &random) {
    std::array<float, sizeof(Shape) / sizeof(float)> fields;
    static_assert(sizeof fields == sizeof(Shape));
    for (float &field : fields)
        field = nasty(random);
    const auto number = [&] { return static_cast<double>(nasty(random)); };
    Case<Shape> made{{{number(), number(), number()}, {number(), number(), number()}}, std::bit_cast<Shape>(fields)};
    if (random.bits() % 2) {
        made.ray.t_min = random.bits() % 2 ? 0 : 0.5;
        made.ray.t_max = over_scales(random, 1, 1e6);
    }
    return made;
}

template <class Shape> Outcome measure_degenerate(const Primitive<Shape> &primitive, const Settings &settings) {
    std::vector<std::uint64_t> wrong(primitive.kernels.size()), hits(primitive.kernels.size());
    std::mutex adding;
    const std::size_t cases = settings.degenerate_cases;
    const std::uint64_t stream = stream_of(primitive.test + "H14", settings.seed);
    parallel_for((cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
        const std::size_t first = chunk * batch_size;
        const auto batch =
            make_batch<Shape>(degenerate_case<Shape>, stream, first, std::min(batch_size, cases - first));
        std::vector<double> t(batch.size());
        for (std::size_t k = 0; k < wrong.size(); ++k) {
            primitive.kernels[k].run(batch, t);
            const double slack = primitive.kernels[k].scalar == "float" ? 1 + 0x1p-23 : 1; // t_max, too, was rounded
            std::uint64_t bad = 0, found = 0;
            for (std::size_t i = 0; i < t.size(); ++i) {
                const auto &ray = batch.rays[i];
                found += t[i] != no_hit;
                bad += t[i] != no_hit && !(std::isfinite(t[i]) && t[i] > ray.t_min && t[i] < ray.t_max * slack);
            }
            const std::lock_guard lock(adding);
            wrong[k] += bad;
            hits[k] += found;
        }
    });
    Outcome outcome;
    for (std::size_t k = 0; k < wrong.size(); ++k) {
        const auto &kernel = primitive.kernels[k];
        Row row;
        row.set("family", "H14").set("test", primitive.test).set("kernel", kernel.name);
        row.set("default", kernel.is_default)
            .set("scalar", kernel.scalar)
            .set("parameter", "nasty numbers in any field");
        row.set("seed", settings.seed).set("cases", cases).set("misclassified", wrong[k]);
        row.set("misclassified_per_million", 1e6 * static_cast<double>(wrong[k]) / static_cast<double>(cases));
        row.set("nan", wrong[k]).set("hits", hits[k]);
        const bool asked = kernel.is_default || !kernel.no_worse_than.empty();
        if (asked)
            row.set("reached", wrong[k] == 0);
        outcome.passed = outcome.passed && (wrong[k] == 0 || !asked);
        outcome.rows.push_back(row);
    }
    return outcome;
}

// The defaults answer as the named kernel does, in the scalar of each if it has that: whether they are missed.
template <class Shape> void replace_defaults(Primitive<Shape> &primitive, const std::string &name) {
    const auto find = [&](const auto &wanted) { return std::ranges::find_if(primitive.kernels, wanted); };
    for (auto &kernel : primitive.kernels) {
        if (!kernel.is_default)
            continue;
        auto other =
            find([&](const auto &one) { return one.name == name && one.scalar == kernel.scalar && !one.is_default; });
        if (other == primitive.kernels.end())
            other = find([&](const auto &one) { return one.name == name && !one.is_default; });
        if (other == primitive.kernels.end())
            throw InputError("--replace-default " + primitive.test + "=" + name, "there is no such kernel");
        kernel.name = other->name + " in place of the default";
        kernel.run = other->run;
    }
}

// The suite of a primitive, which says by itself to which families it has something to say.
template <class Shape> Suite suite(Primitive<Shape> described) {
    described.cells.push_back({"H15", "easy rays", described.random});
    Suite made{described.test, {"H14"}, {}};
    for (const auto &cell : described.cells)
        if (std::ranges::find(made.families, cell.family) == made.families.end())
            made.families.push_back(cell.family);
    made.measure = [described = std::move(described)](const Settings &settings) {
        Primitive<Shape> primitive = described;
        if (const auto replaced = settings.replaced.find(primitive.test); replaced != settings.replaced.end())
            replace_defaults(primitive, replaced->second);
        add_reader_rows(settings.reader, primitive.test, primitive.kernels);
        add_shader_row(settings.shaders, primitive.test, primitive.all_in_float, primitive.kernels);
        Outcome outcome = measure(primitive, settings);
        if (settings.wants("H14"))
            append(outcome, measure_degenerate(primitive, settings));
        return outcome;
    };
    return made;
}

} // namespace course::hard
