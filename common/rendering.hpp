// From "the colour of one pixel" to a picture: tiles on every core, progress, and a tally of the rays.
#pragma once
#include "common/image.hpp"
#include "common/viewpoint.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace course {

// Fills the pixels of one tile of the picture; called from many threads, each with tiles of its own.
using TileFunction = std::function<void(const Tile &, Picture &)>;

// What a chapter hands to the file writer and to the live window alike.
using Renderer = std::function<TileFunction(const Viewpoint &, int width, int height)>;

// The tile function that calls colour(x, y) for each pixel; x counts from the left, y from the top.
template <class ColourOf> TileFunction each_pixel(ColourOf colour) {
    return [colour = std::move(colour)](const Tile &tile, Picture &picture) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x)
                picture(x, y) = colour(x, y);
    };
}

// One more ray was traced by this thread. render_picture adds up what every thread counted.
inline thread_local std::uint64_t rays_of_this_thread = 0;
inline void count_ray() { ++rays_of_this_thread; }

struct RenderedPicture {
    Picture picture;
    double seconds;     // from the first tile to the last
    std::uint64_t rays; // as told by count_ray()
    double finished;    // the share of tiles that are done: below 1 after Ctrl-C
};

RenderedPicture render_picture(const std::string &label, int width, int height, const TileFunction &fill);

} // namespace course
