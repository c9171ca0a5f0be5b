// Lesson 07, the counter-example: one material that can do everything, as note A's shader has it.
#pragma once
#include "chapters/07_glass/dielectric.hpp"

namespace course {

// A coefficient that may be a texture, which is found out at each look-up.
struct AnyCoefficient {
    Colour constant{0};
    std::shared_ptr<const Placed<Checker>> texture = nullptr;
};
template <class T, class Shape> Colour value(const AnyCoefficient &any, const Surface<T, Shape> &surface) {
    return any.texture ? colour_at(*any.texture, uv(surface)) : any.constant;
}

// All of {r, t, g, d, n} (A 3.1.1) on every surface, and the media of both sides. What is black is found out at each
// hit.
struct Everything {
    AnyCoefficient diffuse, reflection, transmission, glow;
    Tinted<> inside{1, Colour(0)}, outside{1, Colour(0)};
};

template <class T, class Shape, class World, class AnyPath>
Colour shade(const Everything &material, const Surface<T, Shape> &surface, const Arrival<World, AnyPath> &arrival) {
    Colour sum = value(material.glow, surface);
    if (const Colour diffuse = value(material.diffuse, surface); diffuse != Colour(0))
        sum += shade(Diffuse<>{diffuse}, surface, arrival);
    const Colour reflection = value(material.reflection, surface), transmission = value(material.transmission, surface);
    if (transmission != Colour(0))
        sum += shade(
            Dielectric<Tinted<>, Tinted<>, Colour, Colour>{material.inside, material.outside, reflection, transmission},
            surface, arrival);
    else if (reflection != Colour(0))
        sum += shade(Mirror<>{reflection}, surface, arrival);
    return sum;
}

// What each material of the lesson's scenes is as an Everything.
inline AnyCoefficient any_of(const Colour &c) { return {c}; }
inline AnyCoefficient any_of(const Placed<Checker> &c) { return {Colour(0), std::make_shared<Placed<Checker>>(c)}; }
inline Tinted<> tinted(const Clear<> &medium) { return {medium.index, Colour(0)}; }
inline Tinted<> tinted(const Tinted<> &medium) { return medium; }

template <class C> void add_to(Everything &all, const Diffuse<C> &m) { all.diffuse = any_of(m.diffuse); }
template <class C> void add_to(Everything &all, const Mirror<C> &m) { all.reflection = any_of(m.reflection); }
template <class C> void add_to(Everything &all, const Glow<C> &m) { all.glow = any_of(m.glow); }
template <class I, class O> void add_to(Everything &all, const Dielectric<I, O> &m) {
    all.reflection = all.transmission = {Colour(1)};
    all.inside = tinted(m.inside), all.outside = tinted(m.outside);
}
template <class... Parts> void add_to(Everything &all, const Sum<Parts...> &sum) {
    std::apply([&](const auto &...parts) { (add_to(all, parts), ...); }, sum.parts);
}

// The same world with the one material on every surface.
template <class... Shapes, class... Materials, class AnyLights, class AnySky>
auto with_everything(const World<Scene<Object<Shapes, Materials>...>, AnyLights, AnySky> &world) {
    const auto convert = []<class Shape, class Material>(const std::vector<Object<Shape, Material>> &objects) {
        std::vector<Object<Shape, Everything>> result;
        for (const auto &object : objects) {
            result.push_back({object.shape, {}});
            add_to(result.back().material, object.material);
        }
        return result;
    };
    return World{std::apply([&](const auto &...lists) { return Scene(convert(lists)...); }, world.scene.shapes),
                 world.lights, world.sky, world.limits};
}

} // namespace course
