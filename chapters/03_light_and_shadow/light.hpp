// Lesson 03, step 3: lights, and the one way in which every light is asked what it sends to a point.
#pragma once
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace course {

// What arrives at a point from one place of a light, if nothing is in the way.
struct LightSample {
    Vec<double> direction; // to the light, of length one
    double distance;       // a shadow ray's t_max
    Colour radiance;       // what a white surface that faces the light would send out
};

// The sample of a light at `place`, seen from `point`. The distance ends short of the light by the rounding of both
// places, so that a lamp that is itself an object of the scene does not shadow its own light.
inline LightSample sample_towards(const Vec<double> &place, const Vec<double> &point) {
    const Vec<double> to_light = place - point;
    const double distance = length(to_light);
    return {to_light / distance, distance - rounding_bound(point, place), Colour(0)};
}

// Light from one point, alike in all directions. The intensity is what a white surface at distance one, facing the
// light, would send out: as in A eq. 61, the 1/pi of a scattering surface is part of it.
struct PointLight {
    Vec<double> position;
    Colour intensity;
};

// Calls visit(sample) for every sample of the light. A point has but one.
template <class Visit>
void for_each_sample(const PointLight &light, const Vec<double> &point, Random &, Visit &&visit) {
    LightSample sample = sample_towards(light.position, point);
    const Vec<double> r = light.position - point;
    sample.radiance = static_cast<float>(1 / dot(r, r)) * light.intensity;
    visit(sample);
}

// A parallelogram, that shines to the side from which a, then b run counter-clockwise.
struct Rectangle {
    Vec<double> corner, side_a, side_b;
};
inline Vec<double> place_on(const Rectangle &form, double u, double v) {
    return form.corner + u * form.side_a + v * form.side_b;
}
inline Vec<double> area_vector(const Rectangle &form) { return cross(form.side_a, form.side_b); }

// Chapter 02's disk is a lamp as well. A ring's area grows with the square of its radius, hence the root.
template <class S> Vec<double> place_on(const Disk<S> &disk, double u, double v) {
    const Vec<double> n = normalize(Vec<double>(disk.normal));
    const Vec<double> across = normalize(cross(n, std::abs(n.x) < 0.6 ? Vec<double>(1, 0, 0) : Vec<double>(0, 1, 0)));
    const double radius = static_cast<double>(disk.radius) * std::sqrt(u), angle = 2 * pi * v;
    return Vec<double>(disk.centre) + radius * (std::cos(angle) * across + std::sin(angle) * cross(n, across));
}
template <class S> Vec<double> area_vector(const Disk<S> &disk) {
    const double radius = static_cast<double>(disk.radius);
    return pi * radius * radius * normalize(Vec<double>(disk.normal));
}

// A glowing surface, seen from its front with the same radiance from everywhere. Form says its shape: place_on() maps
// the unit square to it, keeping the proportions of areas; area_vector() is its area times its normal.
template <class Form> struct AreaLight {
    Form form;
    Colour radiance;
    int strata = 4; // the unit square is cut into strata x strata cells, with one sample in each
};

// Samples that are spread evenly and still random: one at a random place in each cell. Each stands for its cell's area,
// and sends the less, the more aslant and the farther it is: L cos' dA / (pi r²).
template <class Form, class Visit>
void for_each_sample(const AreaLight<Form> &light, const Vec<double> &point, Random &random, Visit &&visit) {
    const Vec<double> area = area_vector(light.form);
    const double cell = 1.0 / light.strata;
    for (int i = 0; i < light.strata; ++i)
        for (int j = 0; j < light.strata; ++j) {
            const double u = (i + random.uniform()) * cell, v = (j + random.uniform()) * cell;
            const Vec<double> place = place_on(light.form, u, v), r = place - point;
            LightSample sample = sample_towards(place, point);
            const double seen_area = std::max(0.0, -dot(area, sample.direction)) * cell * cell;
            sample.radiance = static_cast<float>(seen_area / (pi * dot(r, r))) * light.radiance;
            visit(sample);
        }
}

// One list per kind of light, as Scene has one per kind of shape.
template <class... Kinds> struct Lights {
    std::tuple<std::vector<Kinds>...> kinds;

    explicit Lights(std::vector<Kinds>... lists) : kinds(std::move(lists)...) {}
};

// Calls visit(sample) for every sample of every light.
template <class... Kinds, class Visit>
void for_each_sample(const Lights<Kinds...> &lights, const Vec<double> &point, Random &random, Visit &&visit) {
    const auto visit_list = [&](const auto &list) {
        for (const auto &light : list)
            for_each_sample(light, point, random, visit);
    };
    std::apply([&](const auto &...lists) { (visit_list(lists), ...); }, lights.kinds);
}

} // namespace course
