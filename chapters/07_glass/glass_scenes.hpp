// Lesson 07, step 5: Whitted's picture of 1980, rebuilt; a drink with bubbles; and a furnace to test energy in.
#pragma once
#include "chapters/05_texture/paint.hpp"
#include "chapters/07_glass/annulus.hpp"
#include "chapters/07_glass/dielectric.hpp"

namespace course {

inline constexpr Clear<> air{1}, glass{1.5f}, water{1.333f};
inline constexpr Tinted<> juice{1.345f, {0.06f, 1.1f, 1.5f}};

// The kinds of boundary that the scenes need.
using Pane = Dielectric<>;                          // between clear media
using DrinkInside = Dielectric<Tinted<>>;           // the drink behind the surface
using DrinkOutside = Dielectric<Clear<>, Tinted<>>; // the drink before it

// Two spheres over a checkerboard: the one in front is a shell of glass around air. The board glows faintly in its own
// colours, in place of the light that a whole world would scatter into the shadows (Whitted's ambient term).
inline auto whitted_world() {
    using Board = Sum<Diffuse<Placed<Checker>>, Glow<Placed<Checker>>>;
    using Polished = Sum<Diffuse<>, Mirror<>>;
    const Colour red = screen_colour(206, 44, 36), yellow = screen_colour(240, 206, 62);
    const auto squares = [&](float share) {
        return Placed<Checker>{{share * red, share * yellow}, {0, 0}, {9, 0}, {0, 12}};
    };
    const Vec<float> shell(-0.35f, 1.75f, 1.3f);
    return World{
        Scene(std::vector{Object<Box<>, Board>{{{-4, -0.2f, -9}, {5, 0, 3}}, Board({squares(1)}, {squares(0.14f)})}},
              std::vector{Object<Sphere<>, Pane>{{shell, 0.85f}, {glass, air, {}, {}}},
                          Object<Sphere<>, Pane>{{shell, 0.8f}, {air, glass, {}, {}}}},
              std::vector{Object<Sphere<>, Polished>{{{1.1f, 1.05f, -0.5f}, 0.95f},
                                                     Polished({Colour(0.07f, 0.08f, 0.1f)}, {Colour(0.62f)})}}),
        Lights(std::vector{PointLight{{-7, 14, 9}, Colour(300)}}),
        GradientSky{{0.42f, 0.62f, 0.86f}, {0.07f, 0.2f, 0.55f}, {0.2f, 0.36f, 0.6f}}};
}
inline Viewpoint whitted_view() { return {.eye = {-0.1, 2.2, 6.6}, .target = {0.2, 1.22, 0}, .field_of_view = 31}; }

// The surfaces of a tumbler that stands on y = 0, filled up to `level`. Each is a boundary between just two media, and
// they meet in circles: where the drink ends at the wall, the inner wall changes from glass and drink to glass and air.
struct Tumbler {
    Vec<float> foot;
    float radius = 0.62f, inner = 0.55f, floor = 0.17f, level = 1.12f, height = 1.7f;

    Vec<float> at(float y) const { return foot + Vec<float>(0, y, 0); }
};

inline std::vector<Vec<float>> bubble_places(const Tumbler &tumbler, int count) {
    std::vector<Vec<float>> places;
    Random random(5);
    while (static_cast<int>(places.size()) < count) {
        const double angle = random.uniform(0, 2 * pi), distance = 0.42 * std::sqrt(random.uniform());
        const auto y = static_cast<float>(random.uniform(tumbler.floor + 0.08, tumbler.level - 0.08));
        places.push_back(tumbler.at(y) + Vec<float>(distance * std::cos(angle), 0, distance * std::sin(angle)));
    }
    return places;
}

// `Drink` is a Clear or Tinted medium.
template <class Drink, class Table, class AnySky>
auto drink_world(const Drink &drink, const Object<Plane<>, Table> &table, const AnySky &sky) {
    using Wet = Dielectric<Drink, Clear<>>;
    using Covered = Dielectric<Clear<>, Drink>;
    const Tumbler t{{-0.75f, 0.001f, 0}};
    const Vec<float> up(0, 1, 0), ball(0.95f, 0.701f, 0.1f);
    std::vector<Object<Sphere<>, Covered>> bubbles;
    for (const Vec<float> &place : bubble_places(t, 26))
        bubbles.push_back({{place, 0.025f + 0.03f * static_cast<float>(fraction(37.0 * static_cast<double>(place.x)))},
                           {air, drink, {}, {}}});
    return World{
        Scene(std::vector{table},
              std::vector{Object<Cylinder<>, Pane>{{t.at(0), t.at(t.height), t.radius}, {glass, air, {}, {}}},
                          Object<Cylinder<>, Pane>{{t.at(t.level), t.at(t.height), t.inner}, {air, glass, {}, {}}}},
              std::vector{Object<Disk<>, Pane>{{t.at(0), -up, t.radius}, {glass, air, {}, {}}}},
              std::vector{Object<Annulus<>, Pane>{{{t.at(t.height), up, t.radius}, t.inner}, {glass, air, {}, {}}}},
              std::vector{Object<Cylinder<>, Wet>{{t.at(t.floor), t.at(t.level), t.inner}, {drink, glass, {}, {}}}},
              std::vector{Object<Disk<>, Wet>{{t.at(t.level), up, t.inner}, {drink, air, {}, {}}}},
              std::vector{Object<Disk<>, Covered>{{t.at(t.floor), up, t.inner}, {glass, drink, {}, {}}}}, bubbles,
              std::vector{Object<Sphere<>, Pane>{{ball, 0.7f}, {glass, air, {}, {}}},
                          Object<Sphere<>, Pane>{{ball + Vec<float>(-0.1f, 0.08f, 0.1f), 0.3f}, {air, glass, {}, {}}},
                          Object<Sphere<>, Pane>{{ball + Vec<float>(0.3f, -0.22f, 0.2f), 0.12f}, {air, glass, {}, {}}},
                          Object<Sphere<>, Pane>{{ball + Vec<float>(0.18f, 0.36f, 0.0f), 0.1f}, {air, glass, {}, {}}}}),
        Lights(std::vector{PointLight{{-60, 70, 30}, Colour(8600, 7600, 6400)},
                           PointLight{{70, 60, 60}, Colour(2400, 2600, 3000)}}),
        sky};
}
inline Viewpoint drink_view() { return {.eye = {0.1, 1.85, 5.2}, .target = {0.08, 0.82, 0}, .field_of_view = 30}; }

} // namespace course
