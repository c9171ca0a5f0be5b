// Lesson 17, step 5: lamps as light.glsl has them.
#pragma once
#include "chapters/17_gpu/packed.hpp"

namespace course {

// The kinds of light.glsl.
enum class LampKind { point, rectangle, disk };

// What a lamp's texels hold: a corner and two sides, or a middle and two half-axes.
struct LampForm {
    LampKind kind;
    Vec<double> place, first, second;
};
inline LampForm lamp_form(const Rectangle &form) {
    return {LampKind::rectangle, form.corner, form.side_a, form.side_b};
}
inline LampForm lamp_form(const Disk<> &disk) { // whose rim chapter 03 walks along, from v = 0 on
    const Vec<double> middle(disk.centre);
    return {LampKind::disk, middle, place_on(disk, 1, 0) - middle, place_on(disk, 1, 0.25) - middle};
}

inline void put_lamp(PackedScene &scene, const PointLight &light) {
    put(scene, Vec<float>(light.position), 0);
    put(scene, light.intensity, 0);
    for (int i = 2; i < scene.lamp_size; ++i)
        put(scene, {0, 0, 0}, 0);
}
template <class Form> void put_lamp(PackedScene &scene, const PassLight<Form> &lamp) {
    const LampForm form = lamp_form(lamp.light.form);
    put(scene, Vec<float>(form.place), static_cast<float>(form.kind));
    put(scene, lamp.light.radiance, 0);
    put(scene, Vec<float>(form.first), 0);
    put(scene, Vec<float>(form.second), 0);
    put(scene, Vec<float>(area_vector(lamp.light.form)), 0);
    scene.strata = lamp.light.strata; // the same for all lamps
}

template <class... Kinds> void put_lamps(PackedScene &scene, const Lights<Kinds...> &lights) {
    scene.first_light = here(scene);
    scene.lamp_size = scene.defines.contains("HAS_AREA_LIGHT") ? 5 : 2;
    const auto put_list = [&](const auto &list) {
        for (const auto &lamp : list) {
            put_lamp(scene, lamp);
            ++scene.light_count;
        }
    };
    std::apply([&](const auto &...lists) { (put_list(lists), ...); }, lights.kinds);
}

} // namespace course
