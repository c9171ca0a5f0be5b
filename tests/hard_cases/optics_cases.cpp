// H13: total reflection decided at the critical angle, and Fresnel's shares that must add up.
#include "chapters/07_glass/optics.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/suites.hpp"

namespace course::hard {
namespace {

struct Boundary {
    double cosine;
    float n_from, n_to;
};

// The indices 1 and up to 2.42 (diamond) either way, and an angle as far off the critical one as is asked for.
Boundary near_critical(Random &random, double off) {
    const auto n = static_cast<float>(random.uniform(1.0001, 2.42));
    const bool leaves = random.bits() % 4 != 0;
    const double sine = std::min(1.0, (1 + off * random.uniform(-1, 1)) / static_cast<double>(n));
    const double cosine = leaves ? std::sqrt((1 - sine) * (1 + sine)) : random.uniform();
    return {cosine, leaves ? n : 1.0f, leaves ? 1.0f : n};
}

// As the notes lead one to write it, in float: sin² by 1 - cos², times the squared ratio of the indices.
bool textbook_decision(const Boundary &b) {
    const float cosine = static_cast<float>(b.cosine), ratio = b.n_from / b.n_to;
    return ratio * ratio * (1 - cosine * cosine) > 1;
}

double textbook_sum(const Boundary &b) {
    const float cos_i = static_cast<float>(b.cosine), n = b.n_to / b.n_from;
    const float cos_t = std::sqrt(std::max(0.0f, 1 - (1 - cos_i * cos_i) / (n * n)));
    const float s = (cos_i - n * cos_t) / (cos_i + n * cos_t), p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    const float reflected = (s * s + p * p) / 2;
    // A eq. 58 as printed, without the factor n cos t / cos i.
    const float ts = 1 / (cos_i + n * cos_t), tp = 1 / (n * cos_i + cos_t);
    return static_cast<double>(reflected + 2 * cos_i * cos_i * (ts * ts + tp * tp));
}

Outcome optics(const Settings &settings) {
    Outcome outcome;
    for (const int power : {2, 3, 4, 5, 6, 7, 16}) {
        const double off = std::pow(10.0, -power);
        const std::string parameter = "critical angle +- 1e-" + std::to_string(power);
        const std::uint64_t stream = stream_of("optics" + parameter, settings.seed);
        std::array<std::uint64_t, 2> wrong{};
        std::array<double, 2> sum_error{}; // in ulps of 1 in double
        std::mutex adding;
        parallel_for((settings.cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
            const std::size_t end = std::min(settings.cases, (chunk + 1) * batch_size);
            for (std::size_t i = chunk * batch_size; i < end; ++i) {
                Random random(stream, i);
                const Boundary b = near_critical(random, off);
                const bool truth =
                    exact::totally_reflects(b.cosine, static_cast<double>(b.n_from), static_cast<double>(b.n_to));
                const std::array given{textbook_decision(b), totally_reflects(b.cosine, b.n_from, b.n_to)};
                std::array<double, 2> off_one{};
                if (!truth) {
                    const Fresnel shares = fresnel(b.cosine, b.n_from, b.n_to);
                    off_one = {textbook_sum(b) - 1, shares.reflected + shares.transmitted - 1};
                }
                const std::lock_guard lock(adding);
                for (const std::size_t k : {0u, 1u}) {
                    wrong[k] += given[k] != truth;
                    sum_error[k] = std::max(sum_error[k], std::abs(off_one[k]) * 0x1p52);
                }
            }
        });
        for (const std::size_t k : {0u, 1u}) {
            const bool reached = wrong[k] == 0 && sum_error[k] <= 2;
            Row row;
            row.set("family", "H13").set("test", "glass").set("kernel", k ? "chapter 07" : "as printed");
            row.set("default", k == 1).set("scalar", k ? "double" : "float").set("parameter", parameter);
            row.set("seed", settings.seed).set("cases", settings.cases).set("misclassified", wrong[k]);
            row.set("misclassified_per_million",
                    1e6 * static_cast<double>(wrong[k]) / static_cast<double>(settings.cases));
            row.set("sum_error_ulp_max", sum_error[k]);
            if (k)
                row.set("reached", reached);
            outcome.passed = outcome.passed && (reached || !k);
            outcome.rows.push_back(row);
        }
    }
    return outcome;
}

} // namespace

Suite optics_suite() { return {"glass", {"H13"}, optics}; }

} // namespace course::hard
