// Lesson 03, step 5: the light that reaches a surface straight from the lights.
#pragma once
#include "chapters/03_light_and_shadow/any_hit.hpp"
#include "chapters/03_light_and_shadow/light.hpp"
#include "chapters/03_light_and_shadow/material.hpp"
#include "common/rendering.hpp"

namespace course {

// The normal of the side that is looked at along `direction`.
inline Vec<double> facing(const Vec<double> &normal, const Vec<double> &direction) {
    return dot(normal, direction) > 0 ? -normal : normal;
}

// Whether nothing of the scene lies between the surface and the place that the sample comes from.
template <class T, class Shape, class AnyScene, class Spawn = ExactSpawn>
bool lit_by(const LightSample &sample, const Surface<T, Shape> &surface, const AnyScene &scene, Spawn spawn = {}) {
    count_ray();
    return !any_hit(spawn(surface, sample.direction, sample.distance), scene);
}

// The light that a surface with the diffuse coefficient scatters to the viewer: the sum over all lights' samples that
// are not shadowed of diffuse max(0, cos) radiance, with the cosine to the normal on the viewer's side. This is A eq.
// 61 with the coefficient and the max that are missing there.
template <class T, class Shape, class AnyScene, class AnyLights, class Spawn = ExactSpawn>
Colour direct_light(const Surface<T, Shape> &surface, const Vec<double> &facing_normal, const Colour &diffuse,
                    const AnyScene &scene, const AnyLights &lights, Random &random, const Spawn &spawn = {}) {
    Colour sum(0);
    for_each_sample(lights, Vec<double>(surface.point), random, [&](const LightSample &sample) {
        const double cosine = dot(sample.direction, facing_normal);
        if (cosine > 0 && sample.radiance != Colour(0) && lit_by(sample, surface, scene, spawn))
            sum += static_cast<float>(cosine) * sample.radiance;
    });
    return diffuse * sum;
}

} // namespace course
