// Lesson 05, step 5: pictures that the lesson paints itself, so that nothing has to be fetched.
#pragma once
#include "chapters/05_texture/sky.hpp"
#include "common/image_files.hpp"
#include "common/parallel.hpp"
#include "common/random.hpp"

namespace course {

// The picture of a function of (u, v), each texel the function at its centre.
template <class ColourOfUv> Picture paint(int width, int height, const ColourOfUv &colour) {
    Picture picture(width, height);
    parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x)
            picture(x, y) = colour(Uv{(x + 0.5) / width, 1 - (y + 0.5) / height});
    });
    return picture;
}

// A colour as a painter mixes it on the screen, 0 to 255.
inline Colour screen_colour(int red, int green, int blue) {
    const auto linear = [](int encoded) { return linear_from_srgb(static_cast<float>(encoded) / 255); };
    return {linear(red), linear(green), linear(blue)};
}

// 0 below `low`, 1 above `high`, and a smooth rise between.
inline double rise(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// A number in [0, 1) for each point of a lattice.
inline double lattice_value(const Vec<double> &corner, std::uint64_t seed) {
    const auto bits = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)); };
    return Random(seed, bits(corner.x) * 73856093u ^ bits(corner.y) * 19349663u ^ bits(corner.z) * 83492791u).uniform();
}

// Smooth noise: the lattice's numbers blended between its points (value noise; Perlin's own blends slopes).
inline double noise(const Vec<double> &p, std::uint64_t seed) {
    const Vec<double> low = floor(p), part = p - low, blend = part * part * (3.0 - 2.0 * part);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const Vec<double> corner(i & 1, (i >> 1) & 1, (i >> 2) & 1);
        const Vec<double> share = mix(1.0 - blend, blend, corner);
        sum += share.x * share.y * share.z * lattice_value(low + corner, seed);
    }
    return sum;
}

// Noise on many scales, each half as large and half as strong: mountains, clouds, coasts. In [0, 1).
inline double rough_noise(Vec<double> p, int scales, std::uint64_t seed) {
    double sum = 0, strength = 0.5, total = 0;
    for (int i = 0; i < scales; ++i, strength /= 2, p *= 2.03) {
        sum += strength * noise(p, seed + static_cast<std::uint64_t>(i));
        total += strength;
    }
    return sum / total;
}

inline Colour blend(const Colour &a, const Colour &b, double share) { return mix(a, b, static_cast<float>(share)); }

// A small planet: sea, coast, forest, mountains, polar ice, and clouds over all.
inline Picture paint_planet(int width, std::uint64_t seed) {
    return paint(width, width / 2, [=](const Uv &at) {
        const double longitude = 2 * pi * at.x, from_north = pi * (1 - at.y);
        const Vec<double> p(std::sin(from_north) * std::cos(longitude), std::cos(from_north),
                            -std::sin(from_north) * std::sin(longitude));
        const double land = rough_noise(2.1 * p + 7.0, 7, seed) + 0.02 * std::cos(3 * longitude);
        const double detail = rough_noise(9.0 * p, 4, seed + 20);
        Colour c = blend(screen_colour(12, 42, 92), screen_colour(30, 112, 150), rise(0.4, 0.53, land));
        if (land > 0.53) {
            c = blend(screen_colour(206, 186, 130), screen_colour(60, 112, 52), rise(0.532, 0.56, land));
            c = blend(c, screen_colour(122, 96, 66), rise(0.58, 0.66, land + 0.12 * (detail - 0.5)));
            c = blend(c, screen_colour(240, 240, 240), rise(0.66, 0.71, land + 0.12 * (detail - 0.5)));
        }
        c = blend(c, screen_colour(236, 242, 248), rise(0.78, 0.86, std::abs(p.y) + 0.25 * (detail - 0.5)));
        return blend(c, screen_colour(250, 250, 250),
                     0.9 * rise(0.54, 0.68, rough_noise(4.0 * p + 31.0, 5, seed + 40)));
    });
}

// A wall of bricks; every other row is shifted by half a brick, so with an even number of rows the wall repeats.
inline Picture paint_bricks(int width, int columns, int rows, std::uint64_t seed) {
    return paint(width, width, [=](const Uv &at) {
        const double row = std::floor(at.y * rows), shifted = at.x * columns + (std::fmod(row, 2) < 1 ? 0 : 0.5);
        const double column = std::fmod(std::floor(shifted), columns);
        const double across = std::min(fraction(shifted), 1 - fraction(shifted)) / columns;
        const double up = std::min(fraction(at.y * rows), 1 - fraction(at.y * rows)) / rows;
        const double brick = rise(0.005, 0.011, std::min(across, up));
        const double tone = lattice_value({column, row, 0}, seed),
                     grain = rough_noise({60 * at.x, 60 * at.y, 1}, 3, seed);
        const Colour clay = blend(screen_colour(134, 58, 40), screen_colour(196, 110, 74), 0.7 * tone + 0.3 * grain);
        return blend(screen_colour(196, 188, 176), clay, brick) * static_cast<float>(0.75 + 0.5 * grain);
    });
}

// Planks of wood with their grain.
inline Picture paint_planks(int width, int planks, std::uint64_t seed) {
    return paint(width, width, [=](const Uv &at) {
        const double plank = std::floor(at.y * planks), within = fraction(at.y * planks);
        const double tone = lattice_value({plank, 3, 0}, seed);
        const double bend = rough_noise({3 * at.x + 9 * plank, 5 * at.y, plank}, 4, seed);
        const double grain = 0.5 + 0.5 * std::sin(60 * within + 40 * bend);
        const Colour wood = blend(screen_colour(132, 84, 44), screen_colour(204, 150, 92), 0.45 * grain + 0.55 * tone);
        return wood * static_cast<float>(rise(0.0, 0.05, std::min(within, 1 - within)) * 0.85 + 0.15);
    });
}

// A target: rings around the middle.
inline Picture paint_target(int width) {
    return paint(width, width, [](const Uv &at) {
        const double ring = 10 * std::hypot(at.x - 0.5, at.y - 0.5); // 5 at the rim
        const Colour colours[]{screen_colour(236, 190, 60), screen_colour(200, 50, 44),   screen_colour(44, 104, 160),
                               screen_colour(40, 42, 48),   screen_colour(236, 230, 216), screen_colour(40, 42, 48)};
        return colours[std::min(static_cast<int>(ring), 5)];
    });
}

// An evening sky as a picture of all directions: `sun` is the direction to the sun.
inline Picture paint_evening(int width, const Vec<double> &sun, std::uint64_t seed) {
    return paint(width, width / 2, [=](const Uv &at) {
        const Vec<double> d = sky_direction(at);
        const double height = std::max(d.y, 0.0), near_sun = 0.5 + 0.5 * dot(d, normalize(sun));
        Colour c = blend(screen_colour(252, 196, 140), screen_colour(70, 120, 190), rise(-0.05, 0.5, height));
        c = blend(c, screen_colour(28, 60, 126), rise(0.3, 1.0, height));
        c += static_cast<float>(std::pow(near_sun, 24)) * Colour(0.9f, 0.45f, 0.15f);
        c += static_cast<float>(3 * rise(0.9994, 0.9997, near_sun)) * Colour(1.0f, 0.8f, 0.5f);
        const Vec<double> overhead = d / (height + 0.12); // where the direction meets a flat layer of clouds
        const double cloud = rise(0.5, 0.78, rough_noise({1.3 * overhead.x, 2, 1.3 * overhead.z}, 6, seed));
        const Colour lit = blend(screen_colour(236, 214, 206), screen_colour(255, 186, 128), std::pow(near_sun, 6));
        c = blend(c, lit, cloud * rise(0.0, 0.12, height));
        const Colour haze = blend(screen_colour(150, 132, 130), screen_colour(226, 166, 122), std::pow(near_sun, 4));
        return blend(haze, c, rise(-0.02, 0.05, d.y));
    });
}

} // namespace course
