// Lesson 05, step 3: textures, which are coefficients that vary over a surface.
#pragma once
#include "chapters/03_light_and_shadow/material.hpp"
#include "chapters/05_texture/uv.hpp"
#include "common/image.hpp"

#include <concepts>
#include <memory>
#include <utility>

namespace course {

// A texture is anything that has a colour at each (u, v): an overload of colour_at().
template <class T>
concept Texture = requires(const T &texture, const Uv &at) {
    { colour_at(texture, at) } -> std::convertible_to<Colour>;
};

// The part of x behind the point: 0 <= fraction < 1, and 0 where x is not finite.
inline double fraction(double x) {
    const double rest = x - std::floor(x);
    return rest < 1 ? rest : 0;
}

// Squares of side 1, dark and light in turn.
struct Checker {
    Colour even, odd;
};
inline Colour colour_at(const Checker &checker, const Uv &at) {
    return (fraction(at.x / 2) < 0.5) == (fraction(at.y / 2) < 0.5) ? checker.even : checker.odd;
}

// What lies above the topmost row of a picture and below the lowest: the row itself (a globe's poles), or the picture
// again (tiles on a floor). To the right and left a picture always repeats.
enum class Border { hold, repeat };

// A picture that many materials may share.
struct ImageTexture {
    std::shared_ptr<const Picture> picture;
    Border border = Border::hold;

    ImageTexture(Picture image, Border above_and_below = Border::hold)
        : picture(std::make_shared<const Picture>(std::move(image))), border(above_and_below) {}
};

// The texel's place: texel i covers [i, i + 1) of the picture's width. Row 0 is at the top, where v is 1.
inline int texel(double place, int count, bool repeat) {
    const int i = static_cast<int>(std::floor(place)); // from -1 to count
    return repeat ? (i + count) % count : std::clamp(i, 0, count - 1);
}

// The nearest texel alone: squares, when looked at closely.
inline Colour nearest_texel(const ImageTexture &texture, const Uv &at) {
    const Picture &image = *texture.picture;
    const bool repeat = texture.border == Border::repeat;
    const double v = repeat ? fraction(at.y) : std::clamp(at.y, 0.0, 1.0);
    return image(texel(fraction(at.x) * image.width, image.width, true),
                 texel((1 - v) * image.height, image.height, repeat));
}

// The four nearest texels, each with the share that it has of a texel-sized square around the place (bilinear).
inline Colour colour_at(const ImageTexture &texture, const Uv &at) {
    const Picture &image = *texture.picture;
    const bool repeat = texture.border == Border::repeat;
    const double v = repeat ? fraction(at.y) : std::clamp(at.y, 0.0, 1.0);
    const double x = fraction(at.x) * image.width - 0.5, y = (1 - v) * image.height - 0.5;
    const auto right = static_cast<float>(x - std::floor(x)), low = static_cast<float>(y - std::floor(y));
    const int x0 = texel(x, image.width, true), x1 = texel(x + 1, image.width, true);
    const int y0 = texel(y, image.height, repeat), y1 = texel(y + 1, image.height, repeat);
    return (1 - low) * ((1 - right) * image(x0, y0) + right * image(x1, y0)) +
           low * ((1 - right) * image(x0, y1) + right * image(x1, y1));
}

// A texture laid differently on the shape: its own coordinates are origin + u across + v up. It repeats a picture,
// turns it, or gives a triangle's corners their places in it (A eq. 5: origin t0, across t1 - t0, up t2 - t0).
template <Texture Inner> struct Placed {
    Inner texture;
    Uv origin{0, 0}, across{1, 0}, up{0, 1};
};
template <class Inner> Colour colour_at(const Placed<Inner> &placed, const Uv &at) {
    return colour_at(placed.texture, placed.origin + at.x * placed.across + at.y * placed.up);
}

// A texture in the place of a constant coefficient: chapter 03's value() with a look-up in it. Which coefficients of a
// material are textures is part of its type, so a constant one costs what it did.
template <Texture Coefficient, class T, class Shape>
Colour value(const Coefficient &texture, const Surface<T, Shape> &surface) {
    return colour_at(texture, uv(surface));
}

// A coefficient that is a number, such as a refractive index: constant ...
template <class T, class Shape> float value(float constant, const Surface<T, Shape> &) { return constant; }

// ... or from `low` where the texture is black to `high` where it is white.
template <Texture Inner> struct Scaled {
    Inner texture;
    float low, high;
};
template <class Inner, class T, class Shape>
float value(const Scaled<Inner> &number, const Surface<T, Shape> &surface) {
    const Colour c = colour_at(number.texture, uv(surface));
    return number.low + (number.high - number.low) * (0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b);
}

} // namespace course
