// Lesson 09, step 10: a picture of the work behind each pixel.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/09_aabb/counters.hpp"
#include "common/digits.hpp"
#include "common/image_files.hpp"
#include "common/rendering.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace course {

// From black over purple and orange to a pale yellow: ever lighter, so that it can be read without seeing hues. The
// nine colours are taken from matplotlib's "inferno" (van der Walt and Smith, CC0). Shares lie in [0, 1].
inline Colour heat_colour(double share) {
    constexpr std::array<std::array<int, 3>, 9> steps{{{0, 0, 4},
                                                       {31, 12, 72},
                                                       {85, 15, 109},
                                                       {136, 34, 106},
                                                       {186, 54, 85},
                                                       {227, 89, 51},
                                                       {249, 140, 10},
                                                       {249, 201, 50},
                                                       {252, 255, 164}}};
    const double place = std::clamp(share, 0.0, 1.0) * (steps.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), steps.size() - 2);
    const double part = place - static_cast<double>(below);
    Colour colour;
    for (std::size_t i = 0; i < 3; ++i)
        colour[static_cast<int>(i)] =
            linear_from_srgb(static_cast<float>((1 - part) * steps[below][i] + part * steps[below + 1][i]) / 255);
    return colour;
}

// Costs from `least` to `most` are told apart by their logarithm: equal steps of colour are equal factors of cost.
struct HeatScale {
    double least = 1, most = 1000;

    double share(double cost) const { return std::log(std::max(cost, least) / least) / std::log(most / least); }
    Colour operator()(double cost) const { return heat_colour(share(cost)); }
};

// What one ray costs: boxes or nodes looked at, and primitives tested.
inline double steps_of(const Counts &counts) { return static_cast<double>(counts.nodes + counts.tests); }

// The steps that the nearest hit of one ray takes in the scene.
template <class AnyScene> double steps_along(const Ray<double> &ray, const AnyScene &scene) {
    Counts counts;
    count_ray();
    closest_hit(CountedRay<double>{ray, &counts}, scene);
    return steps_of(counts);
}

// On a dark label in the lower left corner, a bar of the scale's colours with a number at each power of ten; nothing
// elsewhere. Too small a picture goes without.
inline std::optional<Colour> legend(const HeatScale &scale, int x, int y, int width, int height) {
    const int dot = std::max(1, height / 180), bar = std::min(width / 3, 120 * dot), edge = 4 * dot;
    const int label_width = bar + 16 * dot + edge, label_height = 11 * dot + 2 * edge;
    y -= height - label_height;
    if (width < 320 || y < 0 || x >= label_width)
        return {};
    x -= edge, y -= edge;
    if (x >= 0 && x < bar && y >= 0 && y < 4 * dot)
        return heat_colour(static_cast<double>(x) / bar);
    for (double tick = std::pow(10, std::ceil(std::log10(scale.least) - 1e-9)); tick <= scale.most * 1.0001;
         tick *= 10) {
        const int right = x - static_cast<int>(scale.share(tick) * (bar - 1)), down = y - 6 * dot;
        if (right >= 0 && ((right < dot && y >= 4 * dot && y < 5 * dot) ||
                           (down >= 0 && dot_of_text(short_number(tick), right / dot, down / dot))))
            return Colour(0.8f);
    }
    return Colour(0.012f);
}

// The heat map of any scene, as program.render() takes it. The legend stands at this share of the width.
template <class AnyScene> Renderer heat_map(const AnyScene &scene, const HeatScale &scale, double legend_at = 0) {
    return [&scene, scale, legend_at](const Viewpoint &view, int width, int height) {
        const int shift = static_cast<int>(legend_at * width);
        return each_pixel([&scene, scale, width, height, shift, camera = Camera(view, width, height)](int x, int y) {
            if (const auto drawn = x < shift ? std::nullopt : legend(scale, x - shift, y, width, height))
                return *drawn;
            return scale(steps_along(camera.ray(x + 0.5, y + 0.5), scene));
        });
    };
}

} // namespace course
