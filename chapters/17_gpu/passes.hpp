// Lesson 17, step 10: what a pass samples: one place in every pixel, and one cell of every lamp.
#pragma once
#include "chapters/03_light_and_shadow/light.hpp"

#include <memory>
#include <numeric>

namespace course {

// Where pass number `index` samples each pixel: the first in the middle, the others spread evenly, by multiples of the
// plane's golden ratio (Roberts 2018). All pixels and both tracers take the same places.
inline glm::dvec2 sample_place(int index) {
    const double g = 1.32471795724474602596; // g^3 = g + 1
    const glm::dvec2 place = glm::dvec2(0.5) + static_cast<double>(index) * glm::dvec2(1 / g, 1 / (g * g));
    return place - floor(place);
}

// Chapter 03 cuts a lamp into strata x strata cells and takes a sample from each. Here a pass takes one cell, with
// steps that soon have been everywhere, and so many passes together are chapter 03's light.
inline glm::ivec2 lamp_cell(int pass, int strata) {
    const int cells = strata * strata;
    int step = std::max(1, static_cast<int>(0.618 * cells));
    while (std::gcd(step, cells) != 1) // else it would come back too early
        --step;
    const auto cell = static_cast<int>(static_cast<std::int64_t>(pass) * step % cells);
    return {cell % strata, cell / strata};
}

// The random numbers of a pixel in a pass: the same ones in random.glsl.
inline Random random_of(std::uint64_t seed, int x, int y, int pass) {
    const auto bits = [](int number, int place) { return static_cast<std::uint64_t>(number) << place; };
    return Random(seed, bits(pass, 48) | bits(y, 24) | bits(x, 0));
}

// An area light that shows but the cell of the pass that is drawn.
template <class Form> struct PassLight {
    AreaLight<Form> light;
    std::shared_ptr<const int> pass;
};
template <class Form, class Visit>
void for_each_sample(const PassLight<Form> &one, const Vec<double> &point, Random &random, Visit &&visit) {
    const auto &[form, radiance, strata] = one.light;
    const glm::dvec2 cell(lamp_cell(*one.pass, strata));
    const double u = (cell.x + random.uniform()) / strata, v = (cell.y + random.uniform()) / strata;
    const Vec<double> place = place_on(form, u, v), r = place - point;
    LightSample sample = sample_towards(place, point);
    const double seen_area = std::max(0.0, -dot(area_vector(form), sample.direction));
    sample.radiance = static_cast<float>(seen_area / (pi * dot(r, r))) * radiance;
    visit(sample);
}

} // namespace course
