// Lesson 05, step 6: several samples per pixel, and more of them where the picture needs them.
#pragma once
#include "common/image_files.hpp"
#include "common/random.hpp"
#include "common/rendering.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// The mean over samples x samples cells of the pixel at (x, y), one sample at a random place in each: spread evenly, so
// that an edge is caught in the right proportion, and yet without a pattern. colour_at_place(x, y, random) is asked for
// places in pixels from the top left corner. `seen` is told every sample's colour.
template <class ColourAtPlace, class Seen>
Colour stratified_mean(int x, int y, int samples, Random &random, const ColourAtPlace &colour_at_place, Seen &&seen) {
    const double cell = 1.0 / samples;
    Vec<double> sum(0);
    for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j) {
            const double across = (i + random.uniform()) * cell, down = (j + random.uniform()) * cell;
            const Colour colour = colour_at_place(x + across, y + down, random);
            seen(colour);
            sum += Vec<double>(colour);
        }
    return Colour(sum * (cell * cell));
}

struct Sampling {
    int first = 2;           // first x first samples in every pixel
    int refined = 5;         // and this many squared where the first ones do not agree; no more than first: never
    float tolerance = 0.04f; // how far apart they may be, as a share of the display's range
    std::uint64_t seed = 1;
};

// Colours as the eye compares them: encoded as on the display, and no brighter than it can show.
inline Colour display_colour(const Colour &c) {
    const Colour shown = clamp(c, 0.0f, 1.0f);
    return {srgb_from_linear(shown.r), srgb_from_linear(shown.g), srgb_from_linear(shown.b)};
}

// The range that colours span, channel by channel.
struct ColourRange {
    Colour low{infinity_}, high{-infinity_};

    void add(const Colour &c) { low = min(low, c), high = max(high, c); }
    float widest() const {
        const Colour span = high - low;
        return std::max({span.r, span.g, span.b});
    }

  private:
    static constexpr float infinity_ = std::numeric_limits<float>::infinity();
};

// The tile function that gives each pixel the mean of its samples. A pixel is refined where its own first samples, or
// its first mean and the eight neighbours', span more than the tolerance. Random numbers depend on the pixel alone, and
// the rim of the neighbouring tiles is sampled too, so the picture is the same however it is cut into tiles.
template <class ColourAtPlace> TileFunction antialiased(const Sampling &sampling, ColourAtPlace colour_at_place) {
    return [sampling, colour_at_place](const Tile &tile, Picture &picture) {
        const Tile rim{std::max(tile.x0 - 1, 0), std::max(tile.y0 - 1, 0), std::min(tile.x1 + 1, picture.width),
                       std::min(tile.y1 + 1, picture.height)};
        Picture means(rim.x1 - rim.x0, rim.y1 - rim.y0), encoded = means;
        Image<float> spans(means.width, means.height);
        const auto stream = [&](int x, int y, std::uint64_t pass) {
            return Random(sampling.seed,
                          2 * (static_cast<std::uint64_t>(y) * 0x10000u + static_cast<std::uint64_t>(x)) + pass);
        };

        // Sample every pixel a little.
        for (int y = rim.y0; y < rim.y1; ++y)
            for (int x = rim.x0; x < rim.x1; ++x) {
                Random random = stream(x, y, 0);
                ColourRange range;
                const Colour mean = stratified_mean(x, y, sampling.first, random, colour_at_place,
                                                    [&](const Colour &c) { range.add(display_colour(c)); });
                means(x - rim.x0, y - rim.y0) = mean;
                encoded(x - rim.x0, y - rim.y0) = display_colour(mean);
                spans(x - rim.x0, y - rim.y0) = range.widest();
            }

        // Sample those again, and better, that differ within or from a neighbour.
        const auto disagrees = [&](int x, int y) {
            if (sampling.refined <= sampling.first)
                return false;
            ColourRange range;
            for (int near_y = std::max(y - 1, rim.y0); near_y < std::min(y + 2, rim.y1); ++near_y)
                for (int near_x = std::max(x - 1, rim.x0); near_x < std::min(x + 2, rim.x1); ++near_x)
                    range.add(encoded(near_x - rim.x0, near_y - rim.y0));
            return std::max(range.widest(), spans(x - rim.x0, y - rim.y0)) > sampling.tolerance;
        };
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                Random random = stream(x, y, 1);
                picture(x, y) = disagrees(x, y) ? stratified_mean(x, y, sampling.refined, random, colour_at_place,
                                                                  [](const Colour &) {})
                                                : means(x - rim.x0, y - rim.y0);
            }
    };
}

} // namespace course
