// Lesson 15, step 11: a renderer that collects the rays of a tile and has each kind traced in the way that suits it.
#pragma once
#include "chapters/15_wide_bvh/batch.hpp"
#include "common/rendering.hpp"

#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace course {

// Shadow rays from what a bounce ray has met go all ways, unlike those from what is seen.
enum RayKind : std::size_t { camera_rays, shadow_rays, bounce_rays, far_shadow_rays, ray_kinds };
inline bool wants_any(RayKind kind) { return kind == shadow_rays || kind == far_shadow_rays; }

// Which way each kind takes.
using Ways = std::array<Way, ray_kinds>;
inline constexpr Ways one_by_one{};
inline constexpr Ways by_kind{Way::packets, Way::packets, Way::in_flight, Way::in_flight}; // the fastest: README.md

// What the pixels of a tile ask of a scene. A question that cannot be answered yet is noted down. A pixel is shaded
// again and again, with ever more answers, until it has no question left. So any shading will do that asks
// closest_hit() and any_hit(), with two conditions: it asks the same again if it is told the same, and which rays
// follow does not depend on what a shadow ray finds.
class Questions {
  public:
    explicit Questions(std::size_t pixels) : told_(pixels) {
        for (auto &told : told_)
            told.reserve(8);
    }

    // What follows is asked by this pixel, from the beginning.
    void begin(std::size_t pixel) {
        pixel_ = pixel;
        asked_ = surfaces_ = 0;
        waits_ = false;
    }
    // Whether it had all the answers that it asked for.
    bool has_all() const { return asked_ <= told_[pixel_].size(); }

    Hit<double> ask(const Ray<double> &ray, bool any) {
        const std::size_t number = asked_++;
        surfaces_ += !any;
        if (number < told_[pixel_].size())
            return told_[pixel_][number];
        if (!waits_)
            open_[2 * (surfaces_ > 1) + any].add(ray, {pixel_, number});
        waits_ |= !any; // what comes after a closest hit may depend on it
        return {};
    }

    // Calls trace(kind, rays) for what was asked of each kind: it returns the hits.
    template <class Trace> void answer_all(const Trace &trace) {
        for (std::size_t kind = 0; kind < ray_kinds; ++kind) {
            const List list = std::exchange(open_[kind], {});
            const std::vector<Hit<double>> hits = trace(static_cast<RayKind>(kind), Batch(list.rays));
            for (std::size_t i = 0; i < hits.size(); ++i) {
                auto &told = told_[list.places[i].pixel];
                told.resize(std::max(told.size(), list.places[i].number + 1));
                told[list.places[i].number] = hits[i];
            }
        }
    }

  private:
    struct Place {
        std::size_t pixel, number; // the number of the question among the pixel's
    };
    struct List {
        std::vector<Ray<double>> rays;
        std::vector<Place> places;

        void add(const Ray<double> &ray, const Place &place) {
            rays.push_back(ray);
            places.push_back(place);
        }
    };

    std::vector<std::vector<Hit<double>>> told_; // by pixel
    std::array<List, ray_kinds> open_;
    std::size_t pixel_ = 0, asked_ = 0, surfaces_ = 0; // surfaces: how many closest hits were asked for
    bool waits_ = false;
};

// Stands in for the scene while a pixel is shaded.
template <class AnyScene> struct Deferred {
    const AnyScene &scene;
    Questions &questions;
};

template <class AnyScene> Hit<double> closest_hit(const Ray<double> &ray, const Deferred<AnyScene> &deferred) {
    return deferred.questions.ask(ray, false);
}
template <class AnyScene> bool any_hit(const Ray<double> &ray, const Deferred<AnyScene> &deferred) {
    return bool(deferred.questions.ask(ray, true));
}
template <class AnyScene, class F>
auto with_hit(const Ray<double> &ray, const Hit<double> &hit, const Deferred<AnyScene> &deferred, F &&f) {
    return with_hit(ray, hit, deferred.scene, f);
}

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
