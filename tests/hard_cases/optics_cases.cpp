// H13: total reflection decided at the critical angle, and Fresnel's shares that must add up; on the CPU and in GLSL.
#include "chapters/07_glass/optics.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
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

// Where a formula divides nothing by nothing: straight on, along the boundary, and media that are alike.
Boundary at_an_end(Random &random) {
    const auto n = static_cast<float>(random.uniform(1.0001, 2.42));
    const std::array ends{0.0, 1.0, over_scales(random, 1e-12, 1)};
    const std::array indices{1.0f, n, n};
    return {ends[random.bits() % 3], indices[random.bits() % 3], indices[random.bits() % 3]};
}

// What a kernel says of a boundary.
struct Said {
    bool reflects = false;
    double reflected = 0, transmitted = 0;
    Vec<double> direction{0}; // of the light that passes, in the plane x-z, if the kernel is asked
};

// As the notes lead one to write it, in float: sin² by 1 - cos², times the squared ratio of the indices. The decision:
bool textbook_decision(const Boundary &b) {
    const float cosine = static_cast<float>(b.cosine), ratio = b.n_from / b.n_to;
    return ratio * ratio * (1 - cosine * cosine) > 1;
}

Said as_printed(const Boundary &b) {
    const float cos_i = static_cast<float>(b.cosine), n = b.n_to / b.n_from;
    const float cos_t = std::sqrt(std::max(0.0f, 1 - (1 - cos_i * cos_i) / (n * n)));
    const float s = (cos_i - n * cos_t) / (cos_i + n * cos_t), p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    const float reflected = (s * s + p * p) / 2;
    // A eq. 58 as printed, without the factor n cos t / cos i.
    const float ts = 1 / (cos_i + n * cos_t), tp = 1 / (n * cos_i + cos_t);
    return {textbook_decision(b), static_cast<double>(reflected),
            static_cast<double>(2 * cos_i * cos_i * (ts * ts + tp * tp))};
}

Said chapter_07(const Boundary &b) {
    const Fresnel shares = fresnel(b.cosine, b.n_from, b.n_to);
    return {totally_reflects(b.cosine, b.n_from, b.n_to), shares.reflected, shares.transmitted};
}

double sine_of(double cosine) { return std::sqrt((1 - cosine) * (1 + cosine)); }

std::vector<Said> by_shader(Shaders &shaders, std::span<const Boundary> boundaries) {
    std::vector<glm::vec4> given;
    for (const Boundary &b : boundaries)
        given.push_back({b.cosine, sine_of(b.cosine), b.n_from, b.n_to});
    std::vector<Said> said;
    for (const glm::vec4 &found : shaders.optics(given))
        said.push_back({found.z == 0 && found.w == 0, found.x, found.y, {found.z, 0, found.w}});
    return said;
}

bool truly_reflects(const Boundary &b) {
    return exact::totally_reflects(b.cosine, static_cast<double>(b.n_from), static_cast<double>(b.n_to));
}

// What became of a kernel's answers. One in float gets the cosine rounded, which alone may change the truth: so it is
// judged a second time, by the boundary that it was given.
struct Judged {
    std::uint64_t wrong = 0, wrong_as_given = 0, nan = 0;
    double sum_error = 0; // in ulps of 1 in double
    double reflected_error = 0;
    double direction_error = 0; // the sine of the angle between

    void judge(const Said &said, bool truth) {
        wrong += said.reflects != truth;
        const double sum = said.reflected + said.transmitted;
        nan += !std::isfinite(sum + said.direction.x + said.direction.z);
        if (!truth)
            sum_error = std::max(sum_error, std::abs(sum - 1) * 0x1p52);
    }
    void judge_as_given(const Said &said, const Boundary &given, bool truth) {
        wrong_as_given += said.reflects != truth;
        reflected_error = std::max(reflected_error, std::abs(said.reflected - chapter_07(given).reflected));
        if (said.reflects || truth || said.transmitted == 0)
            return; // no light that goes anywhere
        const double cosine = refracted_cosine(given.cosine, given.n_from, given.n_to);
        const double turned = said.direction.x * cosine + said.direction.z * sine_of(cosine);
        direction_error = std::max(direction_error, std::abs(turned));
    }
    void add(const Judged &other) {
        wrong += other.wrong;
        wrong_as_given += other.wrong_as_given;
        nan += other.nan;
        sum_error = std::max(sum_error, other.sum_error);
        reflected_error = std::max(reflected_error, other.reflected_error);
        direction_error = std::max(direction_error, other.direction_error);
    }
};

enum Which { printed, chapter, shader };
using Judges = std::array<Judged, 3>;

Judges judge(std::span<const Boundary> boundaries, Shaders *shaders) {
    Judges judges;
    const auto on_gpu = shaders ? by_shader(*shaders, boundaries) : std::vector<Said>{};
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
        const Boundary &asked = boundaries[i], given{as_float(asked.cosine), asked.n_from, asked.n_to};
        const bool truth = truly_reflects(asked), truth_as_given = truly_reflects(given);
        judges[chapter].judge(chapter_07(asked), truth);
        judges[printed].judge(as_printed(asked), truth);
        judges[printed].judge_as_given(as_printed(asked), given, truth_as_given);
        if (shaders) {
            judges[shader].judge(on_gpu[i], truth);
            judges[shader].judge_as_given(on_gpu[i], given, truth_as_given);
        }
    }
    return judges;
}

Row optics_row(const std::string &test, Which which, const Judged &judged, const std::string &parameter,
               const Settings &settings) {
    static const std::array<std::string, 3> names{"as printed", "chapter 07", "GLSL"};
    const bool is_default = which == chapter;
    Row row = result_row("H13", test, names[which], is_default, is_default ? "double" : "float", parameter, settings);
    row.set("nan", judged.nan).set("sum_error_ulp_max", judged.sum_error);
    if (!is_default)
        row.set("misclassified_as_given", judged.wrong_as_given).set("reflected_error_max", judged.reflected_error);
    if (which == shader) {
        row.set("direction_error_max", judged.direction_error);
        row.set("reached", judged.nan == 0);
    }
    return row;
}

void measure_cell(const std::string &test, const std::string &parameter, const std::function<Boundary(Random &)> &make,
                  const Settings &settings, Outcome &outcome) {
    const std::uint64_t stream = stream_of("optics" + parameter, settings.seed);
    Judges all;
    std::mutex adding;
    parallel_for((settings.cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
        std::vector<Boundary> boundaries;
        for (std::size_t i = chunk * batch_size; i < std::min(settings.cases, (chunk + 1) * batch_size); ++i) {
            Random random(stream, i);
            boundaries.push_back(make(random));
        }
        const Judges some = judge(boundaries, settings.shaders.get());
        const std::lock_guard lock(adding);
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k].add(some[k]);
    });
    for (const Which which : {printed, chapter, shader}) {
        if (which == shader && !settings.shaders)
            continue;
        const Judged &judged = all[which];
        close_row(outcome, optics_row(test, which, judged, parameter, settings), settings.cases, judged.wrong, 0,
                  which == chapter, judged.nan == 0 && judged.sum_error <= 2);
        outcome.passed = outcome.passed && (which != shader || judged.nan == 0);
    }
}

Outcome optics(const Settings &settings) {
    Outcome outcome;
    for (const int power : {2, 3, 4, 5, 6, 7, 16})
        measure_cell(
            "glass", "critical angle +- 1e-" + std::to_string(power),
            [=](Random &random) { return near_critical(random, std::pow(10.0, -power)); }, settings, outcome);
    measure_cell("glass, its ends", "cosine 0 or 1, grazing, equal indices", at_an_end, settings, outcome);
    return outcome;
}

} // namespace

Suite optics_suite() { return {"glass", {"H13"}, optics}; }

} // namespace course::hard
