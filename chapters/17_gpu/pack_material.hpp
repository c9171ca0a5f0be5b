// Lesson 17, step 5: materials as records of coefficients, as material.glsl has them.
#pragma once
#include "chapters/17_gpu/packed.hpp"

namespace course {

// A colour, a checker or a picture, and how it is laid on the shape.
struct Coefficient {
    glm::vec4 first{0}, second{0}, placed{0, 0, 1, 0}, up{0, 1, 0, 0};
};
// Note A's {r, t, g, d, n} (3.1.1), with both sides' media, and chapter 02's light.
struct MaterialRecord {
    Coefficient diffuse, glow, reflection, transmission, facing;
    glm::vec4 inside{0, 0, 0, 1}, outside{0, 0, 0, 1};
};

inline Coefficient coefficient(PackedScene &, const Colour &colour) { return {.first = {colour, 0}}; }
inline Coefficient coefficient(PackedScene &, White) { return {.first = {1, 1, 1, 0}}; }
inline Coefficient coefficient(PackedScene &, const Checker &checker) {
    return {.first = {checker.even, 1}, .second = {checker.odd, 0}};
}
inline Coefficient coefficient(PackedScene &scene, const ImageTexture &texture) {
    return {.first = {0, 0, 0, 2}, .second = {0, 0, 0, put_picture(scene, texture)}};
}
template <class Inner> Coefficient coefficient(PackedScene &scene, const Placed<Inner> &placed) {
    Coefficient inner = coefficient(scene, placed.texture);
    inner.placed = {placed.origin, placed.across};
    inner.up = {placed.up, 0, 0};
    return inner;
}
inline glm::vec4 medium(const Clear<> &clear) { return {0, 0, 0, clear.index}; }
inline glm::vec4 medium(const Tinted<> &tinted) { return {tinted.absorption, tinted.index}; }

template <class C> void add(PackedScene &scene, MaterialRecord &record, const Diffuse<C> &m) {
    record.diffuse = coefficient(scene, m.diffuse);
}
template <class C> void add(PackedScene &scene, MaterialRecord &record, const Glow<C> &m) {
    record.glow = coefficient(scene, m.glow);
}
template <class C> void add(PackedScene &scene, MaterialRecord &record, const Mirror<C> &m) {
    record.reflection = coefficient(scene, m.reflection);
}
template <class C> void add(PackedScene &scene, MaterialRecord &record, const Facing<C> &m) {
    record.facing = coefficient(scene, m.facing);
}
template <class... Kinds> void add(PackedScene &scene, MaterialRecord &record, const Dielectric<Kinds...> &m) {
    record.reflection = coefficient(scene, m.reflection);
    record.transmission = coefficient(scene, m.transmission);
    record.inside = medium(m.inside);
    record.outside = medium(m.outside);
}
template <class... Parts> void add(PackedScene &scene, MaterialRecord &record, const Sum<Parts...> &sum) {
    std::apply([&](const auto &...parts) { (add(scene, record, parts), ...); }, sum.parts);
}

// Returns where the material's record lies.
template <class Material> int put_material(PackedScene &scene, const Material &material) {
    MaterialRecord record;
    add(scene, record, material);
    const int at = here(scene);
    for (const Coefficient &c : {record.diffuse, record.glow, record.reflection, record.transmission, record.facing})
        scene.texels.insert(scene.texels.end(), {c.first, c.second, c.placed, c.up});
    scene.texels.insert(scene.texels.end(), {record.inside, record.outside});
    return at;
}

} // namespace course
