// Grades exercise 07: where light goes at glass, and how it divides.
#include "exercises/07_fresnel/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

namespace course {

namespace {

// Air and water, glass into air, diamond ...
struct Media {
    double from, to;
};
Media any_media(Random &random) { return {random.uniform(1, 2.4), random.uniform(1, 2.4)}; }

// So close to the critical angle that rounding decides.
bool critical(double cos_i, const Media &n) {
    const double along = n.from * cos_i;
    return std::abs(n.from * n.from - n.to * n.to - along * along) < 1e-6;
}

Vec<double> at_angle(const Vec<double> &normal, Random &random, double cos_i) {
    const Vec<double> aside = normalize(cross(normal, any_direction(random)));
    return std::sqrt(1 - cos_i * cos_i) * aside - cos_i * normal;
}

void ask_bent(Check &check, const Task &task, Random &random, double cos_i, const Media &n, bool behind) {
    const Vec<double> against = any_direction(random), d = at_angle(against, random, cos_i);
    const Vec<double> normal = behind ? -against : against;
    check.given({{"direction", d}, {"normal", normal}, {"n from", n.from}, {"n to", n.to}});
    const std::optional<Vec<double>> yours = task.bent(d, normal, n.from, n.to);
    const bool total = exact::totally_reflects(cos_i, n.from, n.to);
    check.that(yours.has_value() != total, total ? "nothing: total reflection" : "a direction",
               yours ? "direction " + in_words(*yours) : "nothing");
    if (!yours)
        return;
    check.that(std::abs(length(*yours) - 1) < 1e-12, "a direction of length 1", "length " + in_words(length(*yours)));
    check.that(dot(*yours, against) < 1e-12, "a direction to the other side", "direction " + in_words(*yours));
    // n sin as vectors: the same size, in the same plane, to the same side.
    const Vec<double> before = n.from * cross(against, d), after = n.to * cross(against, *yours);
    check.that(length(after - before) < 1e-12, "n sin t = " + in_words(length(before)) + " to the same side",
               "direction " + in_words(*yours) + ", n sin t = " + in_words(length(after)));
}

void bent_cases(Check &check, const Task &task, std::uint64_t seed, bool behind, bool total) {
    for (unsigned i = 0; i < 200; ++i) {
        Random random(seed, i);
        const double cos_i = random.uniform(0.01, 1);
        const Media n = any_media(random);
        if (!critical(cos_i, n) && (total || !exact::totally_reflects(cos_i, n.from, n.to)))
            ask_bent(check, task, random, cos_i, n, behind);
    }
}

Shares ask_shares(Check &check, const Task &task, double cos_i, const Media &n) {
    check.given({{"cos i", cos_i}, {"n from", n.from}, {"n to", n.to}});
    return task.divided(cos_i, n.from, n.to);
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("07_glass");
    const char *const snell = "Snell: where it goes", *const fresnel = "Fresnel: how it divides";

    grading.check(
        "n sin i is the same on both sides",
        "The part of the direction along the surface is scaled by n_from / n_to; the part along the normal is what is "
        "left of length one.",
        snell, [&](Check &check) { bent_cases(check, task, 1, false, false); });

    grading.check("from behind the normal as well",
                  "Light leaves the glass, too, and then d · n is positive. Take the cosine without its sign, and bend "
                  "to the side "
                  "to which the ray goes.",
                  snell, [&](Check &check) { bent_cases(check, task, 2, true, false); });

    grading.check(
        "beyond the critical angle nothing passes",
        "From the denser side Snell may ask for a sine above 1, and the square of the cosine becomes negative. Ask for "
        "that before taking its root.",
        snell, [&](Check &check) {
            bent_cases(check, task, 3, false, true);
            bent_cases(check, task, 4, true, true);
        });

    grading.check(
        "straight on: both angles are 0",
        "R = ((n1 - n2) / (n1 + n2))² there. The form with sines and tangents is 0 / 0; the one with cosines needs no "
        "limit.",
        "Is a limit for normal incidence needed?", [&](Check &check) {
            for (unsigned i = 0; i < 50; ++i) {
                Random random(5, i);
                const Media n = any_media(random);
                const double root = (n.from - n.to) / (n.from + n.to);
                const Shares yours = ask_shares(check, task, 1, n);
                check.that(std::abs(yours.reflected - root * root) < 1e-14, "R = " + in_words(root * root),
                           "R = " + in_words(yours.reflected));
            }
        });

    grading.check(
        "what is not mirrored passes: R + T = 1",
        "A beam becomes narrower or wider as it bends, and light travels in glass at another speed: hence the factor "
        "n cos t / cos i, which the notes leave out. With (a - b)² and 4 a b over (a + b)² the sum is 1 by itself.",
        fresnel, [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(6, i);
                const double cos_i = random.uniform(0.01, 1);
                const Shares yours = ask_shares(check, task, cos_i, any_media(random));
                check.that(yours.reflected >= 0 && yours.transmitted >= 0 &&
                               std::abs(yours.reflected + yours.transmitted - 1) < 1e-12,
                           "R + T = 1, both at least 0",
                           "R = " + in_words(yours.reflected) + ", T = " + in_words(yours.transmitted));
            }
        });

    grading.check("at Brewster's angle one polarisation is not mirrored",
                  "Where tan i = n_to / n_from, only the light polarised across the plane of incidence is mirrored, "
                  "((n1² - n2²) / (n1² + n2²))² of it. Unpolarised light is half of each: take the mean.",
                  fresnel, [&](Check &check) {
                      for (unsigned i = 0; i < 50; ++i) {
                          Random random(7, i);
                          const Media n = any_media(random);
                          const double from = n.from * n.from, to = n.to * n.to, across = (from - to) / (from + to);
                          const Shares yours = ask_shares(check, task, n.from / std::sqrt(from + to), n);
                          check.that(std::abs(yours.reflected - 0.5 * across * across) < 1e-13,
                                     "R = " + in_words(0.5 * across * across), "R = " + in_words(yours.reflected));
                      }
                  });

    grading.check(
        "at every angle as Fresnel wrote it",
        "In angles: R = (sin²(i - t) / sin²(i + t) + tan²(i - t) / tan²(i + t)) / 2, where n1 sin i = n2 sin t.",
        fresnel, [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(8, i);
                const double cos_i = random.uniform(0.05, 0.98);
                const Media n = any_media(random);
                const Shares yours = ask_shares(check, task, cos_i, n);
                if (critical(cos_i, n) || exact::totally_reflects(cos_i, n.from, n.to))
                    continue;
                const double in = std::acos(cos_i), out = std::asin(n.from / n.to * std::sin(in));
                const double across = std::sin(in - out) / std::sin(in + out);
                const double within = std::tan(in - out) / std::tan(in + out);
                const double expected = 0.5 * (across * across + within * within);
                check.that(std::abs(yours.reflected - expected) < 1e-9, "R = " + in_words(expected),
                           "R = " + in_words(yours.reflected));
            }
        });

    grading.check("all is mirrored beyond the critical angle, and where light only grazes",
                  "R = 1 and T = 0, exactly: no share may come out as NaN.", snell, [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(9, i);
                          const double cos_i = i % 4 == 0 ? 0 : random.uniform(0, 0.5);
                          const Media n = any_media(random);
                          if (cos_i > 0 && (critical(cos_i, n) || !exact::totally_reflects(cos_i, n.from, n.to)))
                              continue;
                          const Shares yours = ask_shares(check, task, cos_i, n);
                          check.that(yours.reflected == 1 && yours.transmitted == 0, "R = 1, T = 0",
                                     "R = " + in_words(yours.reflected) + ", T = " + in_words(yours.transmitted));
                      }
                  });
}

} // namespace course
