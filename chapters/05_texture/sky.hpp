// Lesson 05, step 4: what a ray sees that meets nothing.
#pragma once
#include "chapters/05_texture/texture.hpp"

#include <array>

namespace course {

// A sky is anything that has a radiance in each direction (of any length): an overload of sky_radiance().
template <class T>
concept Sky = requires(const T &sky, const Vec<double> &direction) {
    { sky_radiance(sky, direction) } -> std::convertible_to<Colour>;
};

// The same on all sides.
struct ConstantSky {
    Colour radiance;
};
inline Colour sky_radiance(const ConstantSky &sky, const Vec<double> &) { return sky.radiance; }

// From the horizon up to the zenith, and one colour for all that lies below.
struct GradientSky {
    Colour horizon, zenith, ground;
};
inline Colour sky_radiance(const GradientSky &sky, const Vec<double> &direction) {
    if (direction.y < 0)
        return sky.ground;
    const double height = direction.y / std::hypot(direction.x, direction.y, direction.z);
    return mix(sky.horizon, sky.zenith, static_cast<float>(std::sqrt(height)));
}

// A picture of the whole sphere of directions, longitude across and latitude up (equirectangular), far away: the
// scene's place in it does not matter. It is the sphere's texture seen from inside, so longitude is mirrored: what is
// to the right in the picture is to the right of somebody who looks at it.
struct ImageSky {
    ImageTexture picture;
};
inline Uv sky_uv(const Vec<double> &direction) {
    const Uv globe = spherical_uv(direction);
    return {fraction(1.75 - globe.x), globe.y}; // the middle of the picture is -z, where a camera at rest looks
}
inline Colour sky_radiance(const ImageSky &sky, const Vec<double> &direction) {
    return colour_at(sky.picture, sky_uv(direction));
}

// The direction that sky_uv() maps to a place of the picture, for painting one.
inline Vec<double> sky_direction(const Uv &at) {
    const double longitude = 2 * pi * (1.75 - at.x), from_north = pi * (1 - at.y);
    return {std::sin(from_north) * std::cos(longitude), std::cos(from_north),
            -std::sin(from_north) * std::sin(longitude)};
}

// Six pictures on the inside of a box: right (+x), left, top (+y), bottom, back (+z), front (-z), which hold their
// rims.
struct SkyBox {
    std::array<ImageTexture, 6> faces;
};

// The face and the place on it. The box's own uv shows a face from outside; from inside it is mirrored.
struct BoxPlace {
    std::size_t face;
    Uv at;
};
inline BoxPlace sky_box_place(const Vec<double> &direction) {
    const Vec<double> size = abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const Vec<double> point = direction / size[axis];
    const Uv outside = uv(Box<double>{Vec<double>(-1), Vec<double>(1)}, point);
    return {static_cast<std::size_t>(2 * axis + (direction[axis] < 0)), {1 - outside.x, outside.y}};
}
inline Colour sky_radiance(const SkyBox &sky, const Vec<double> &direction) {
    const BoxPlace place = sky_box_place(direction);
    return colour_at(sky.faces[place.face], place.at);
}

} // namespace course
