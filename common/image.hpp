// A picture in memory: rows from the top, linear RGB.
#pragma once
#include "common/vectors.hpp"

#include <cstddef>
#include <vector>

namespace course {

template <class Pixel> struct Image {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    Image(int w, int h, Pixel fill = Pixel{})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

    // x counts from the left, y from the top; both must lie inside.
    Pixel &operator()(int x, int y) { return pixels[index(x, y)]; }
    const Pixel &operator()(int x, int y) const { return pixels[index(x, y)]; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

using Picture = Image<Colour>;

// A rectangle of pixels: x0 <= x < x1, y0 <= y < y1.
struct Tile {
    int x0, y0, x1, y1;
};

} // namespace course
