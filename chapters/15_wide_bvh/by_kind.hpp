// Lesson 15, step 12: a renderer that collects the rays of a tile and has each kind traced in the way that suits it.
#pragma once
#include "chapters/15_wide_bvh/questions.hpp"
#include "common/rendering.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace course {

// Which way each kind takes.
using Ways = std::array<Way, ray_kinds>;
inline constexpr Ways one_by_one{};
inline constexpr Ways by_kind{Way::packets, Way::in_flight, Way::in_flight, Way::in_flight}; // the fastest: README.md

// The pixels of a tile in blocks of four by two, whose rays go much the same way.
inline std::vector<std::pair<int, int>> pixels_in_blocks(const Tile &tile) {
    std::vector<std::pair<int, int>> pixels;
    for (int top = tile.y0; top < tile.y1; top += 2)
        for (int left = tile.x0; left < tile.x1; left += 4)
            for (int y = top; y < std::min(top + 2, tile.y1); ++y)
                for (int x = left; x < std::min(left + 4, tile.x1); ++x)
                    pixels.emplace_back(x, y);
    return pixels;
}

// What is seen in a pixel: the mean of `samples` calls of colour(x, y, i, scene).
template <class AnyScene, class ColourOf>
TileFunction each_pixel_ray_by_ray(const AnyScene &scene, int samples, ColourOf colour) {
    return each_pixel([&scene, samples, colour = std::move(colour)](int x, int y) {
        Colour sum(0);
        for (int i = 0; i < samples; ++i)
            sum += colour(x, y, i, scene);
        return sum / static_cast<float>(samples);
    });
}

// The same for all pixels of a tile, with trace(kind, rays) in place of the scene's own answers. Here each sample is
// what asks.
template <class AnyScene, class ColourOf, class Trace> void fill_tile(const Tile &tile, Picture &picture, int samples,
                                                                      const AnyScene &scene, const ColourOf &colour,
                                                                      const Trace &trace) {
    const auto pixels = pixels_in_blocks(tile);
    const auto each = static_cast<std::size_t>(samples);
    std::vector<Colour> colours(pixels.size() * each);
    std::vector<std::size_t> open(colours.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    Questions questions(open.size());
    const std::uint64_t counted = rays_of_this_thread;
    std::uint64_t traced = 0;
    while (!open.empty()) {
        std::erase_if(open, [&](std::size_t sample) {
            questions.begin(sample);
            const auto [x, y] = pixels[sample / each];
            colours[sample] = colour(x, y, static_cast<int>(sample % each), Deferred<AnyScene>{scene, questions});
            return questions.has_all();
        });
        questions.answer_all([&](RayKind kind, Batch rays) {
            traced += rays.size();
            return trace(kind, rays);
        });
    }
    rays_of_this_thread = counted + traced; // shading counted some of them twice
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto first = colours.begin() + static_cast<std::ptrdiff_t>(i * each);
        picture(pixels[i].first, pixels[i].second) =
            std::accumulate(first, first + samples, Colour(0)) / static_cast<float>(samples);
    }
}

// The tile function that has every ray traced in the way of its kind.
template <class AnyScene, class ColourOf>
TileFunction each_pixel_by_kind(const AnyScene &scene, int samples, const Ways &ways, ColourOf colour) {
    return [&scene, samples, ways, colour = std::move(colour)](const Tile &tile, Picture &picture) {
        fill_tile(tile, picture, samples, scene, colour,
                  [&](RayKind kind, Batch rays) { return hits_of(ways[kind], rays, wants_any(kind), scene); });
    };
}

} // namespace course
