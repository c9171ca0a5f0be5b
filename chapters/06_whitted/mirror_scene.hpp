// Lesson 06, step 4: two round mirrors that face each other, with lanterns between.
#pragma once
#include "chapters/05_texture/paint.hpp"
#include "chapters/06_whitted/whitted.hpp"

namespace course {

struct Lantern {
    Vec<float> place;
    Colour colour;
};
inline const Lantern lanterns[]{{{-1.3f, 1.75f, -1.2f}, {1.0f, 0.42f, 0.1f}},
                                {{-0.5f, 2.25f, -0.6f}, {1.0f, 0.16f, 0.16f}},
                                {{0.35f, 2.1f, -0.2f}, {1.0f, 0.66f, 0.22f}},
                                {{1.15f, 1.5f, -0.9f}, {0.16f, 0.5f, 1.0f}}};

// `second`: whether the mirror behind the viewer is there.
inline auto mirror_world(bool second = true) {
    // The mirrors lean a little, so that their images wander off to the side instead of hiding each other.
    const Mirror<> silver{Colour(0.86f, 0.91f, 0.88f)};
    const Diffuse<> gold{screen_colour(196, 146, 62)};
    std::vector mirrors{Object<Disk<>, Mirror<>>{{{0, 1.55f, -2.5f}, {0.004f, -0.009f, 1}, 1.5f}, silver}};
    std::vector frames{Object<Disk<>, Diffuse<>>{{{0, 1.55f, -2.51f}, {0.004f, -0.009f, 1}, 1.6f}, gold}};
    if (second) {
        mirrors.push_back({{{0, 1.55f, 2.5f}, {0.004f, -0.009f, -1}, 1.5f}, silver});
        frames.push_back({{{0, 1.55f, 2.51f}, {0.004f, -0.009f, -1}, 1.6f}, gold});
    }

    std::vector<Object<Sphere<>, Glow<>>> glowing;
    std::vector<PointLight> lights{{{4, 9, 5}, Colour(62, 58, 70)}};
    for (const Lantern &lantern : lanterns) {
        glowing.push_back({{lantern.place, 0.12f}, {lantern.colour}});
        lights.push_back(
            {Vec<double>(lantern.place) - Vec<double>(0, 0.13, 0), 1.2f * lantern.colour}); // just below it
    }

    using Polished = Sum<Diffuse<Placed<Checker>>, Mirror<>>;
    const Checker tiles{screen_colour(186, 178, 170), screen_colour(48, 44, 56)};
    return World{
        Scene(std::vector{Object<Plane<>, Polished>{
                  {{0, 0, 0}, {0, 1, 0}},
                  Polished({Placed<Checker>{tiles, {0, 0}, {1.6, 0}, {0, 1.6}}}, {Colour(0.16f)})}},
              mirrors, frames, glowing,
              std::vector{Object<Sphere<>, Mirror<>>{{{-0.75f, 0.5f, -0.9f}, 0.5f}, {Colour(0.93f, 0.9f, 0.86f)}}},
              std::vector{Object<Sphere<>, Diffuse<>>{{{0.6f, 0.32f, -1.1f}, 0.32f}, {screen_colour(178, 40, 44)}},
                          Object<Sphere<>, Diffuse<>>{{{0.1f, 0.2f, -0.6f}, 0.2f}, {screen_colour(40, 96, 160)}},
                          Object<Sphere<>, Diffuse<>>{{{-1.6f, 0.26f, -0.9f}, 0.26f}, {screen_colour(214, 170, 60)}}}),
        Lights(lights), GradientSky{{0.22f, 0.13f, 0.14f}, {0.012f, 0.02f, 0.06f}, {0.05f, 0.04f, 0.05f}}};
}

// A room whose walls, floor and ceiling all are mirrors: a ray ends only at a lantern or a ball.
inline auto closed_room() {
    std::vector<Object<Sphere<>, Glow<>>> glowing;
    for (const Lantern &lantern : lanterns)
        glowing.push_back({{lantern.place, 0.3f}, {lantern.colour}});
    return World{Scene(std::vector{Object<Box<>, Mirror<>>{{{-2.6f, 0, -2.6f}, {2.6f, 2.8f, 2.6f}}, {Colour(0.86f)}}},
                       glowing,
                       std::vector{Object<Sphere<>, Diffuse<>>{{{0.6f, 0.32f, -1.1f}, 0.32f}, {Colour(0.6f)}}}),
                 Lights(std::vector{PointLight{{0, 2.6, 0}, Colour(3)}}), ConstantSky{Colour(0)}};
}

inline Viewpoint mirror_view() { return {.eye = {0.62, 1.8, 2.3}, .target = {-0.12, 1.17, -2.5}, .field_of_view = 49}; }

} // namespace course
