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

// What lies beyond a picture's rim: `around` repeats it to the right and left and holds its topmost and lowest row (a
// globe, a column), `repeat` repeats it on all sides (tiles on a floor), `hold` holds its rim on all sides.
enum class Border { around, repeat, hold };

// A picture that many materials may share.
struct ImageTexture {
    std::shared_ptr<const Picture> picture;
    Border border;

    ImageTexture(Picture image, Border beyond = Border::around)
        : picture(std::make_shared<const Picture>(std::move(image))), border(beyond) {}

    bool repeats_across() const { return border != Border::hold; }
    bool repeats_up() const { return border == Border::repeat; }
};

// Texel i covers [i, i + 1) of the picture's width, from the left; rows are counted from the top, where v is 1.
inline Uv place_in_picture(const ImageTexture &texture, const Uv &at) {
    const auto held = [](double x) { return std::min(std::max(0.0, x), 1.0); }; // in this order, NaN becomes 0
    const double u = texture.repeats_across() ? fraction(at.x) : held(at.x);
    const double v = texture.repeats_up() ? fraction(at.y) : held(at.y);
    return {u * texture.picture->width, (1 - v) * texture.picture->height};
}

// The texel of a place from -1 to count.
inline int texel(double place, int count, bool repeats) {
    const int i = static_cast<int>(std::floor(place));
    return repeats ? (i + count) % count : std::clamp(i, 0, count - 1);
}

// The nearest texel alone: squares, when looked at closely.
inline Colour nearest_texel(const ImageTexture &texture, const Uv &at) {
    const Picture &image = *texture.picture;
    const Uv place = place_in_picture(texture, at);
    return image(texel(place.x, image.width, texture.repeats_across()),
                 texel(place.y, image.height, texture.repeats_up()));
}

// The four nearest texels, each with the share that it has of a texel-sized square around the place (bilinear).
inline Colour colour_at(const ImageTexture &texture, const Uv &at) {
    const Picture &image = *texture.picture;
    const auto column = [&](double x) { return texel(x, image.width, texture.repeats_across()); };
    const auto row = [&](double y) { return texel(y, image.height, texture.repeats_up()); };
    const Uv place = place_in_picture(texture, at) - 0.5, share = place - floor(place);
    const auto right = static_cast<float>(share.x), low = static_cast<float>(share.y);
    const int x0 = column(place.x), x1 = column(place.x + 1), y0 = row(place.y), y1 = row(place.y + 1);
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
