// Lesson 01, the experiment: shoot the rays from the light instead, and count how few ever reach the eye.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/01_ray_casting/sphere.hpp"
#include "common/random.hpp"

#include <algorithm>
#include <cstdint>

namespace course {

// A direction of length one, every direction alike: Archimedes' theorem makes its z uniform.
inline Vec<double> uniform_direction(Random &random) {
    const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi);
    const double radius = std::sqrt(std::max(0.0, 1 - z * z));
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

struct ForwardTally {
    std::uint64_t shot = 0, hit_something = 0, reached_eye = 0;
};

// One photon: from the light in a random direction, then from surface to surface, leaving each in a direction drawn
// from the cosine law, until it enters the pupil, flies away, or has bounced `bounces` times.
template <class ForwardScene> void shoot_photon(const Vec<double> &light, const ForwardScene &scene,
                                                const Sphere<> &pupil, int bounces, Random &random,
                                                ForwardTally &tally) {
    ++tally.shot;
    Ray<double> ray{light, uniform_direction(random)};
    for (int bounce = 0; bounce <= bounces; ++bounce) {
        const auto hit = closest_hit(ray, scene);
        if (const auto eye = intersect(ray, pupil); eye && *eye < hit.t) {
            ++tally.reached_eye;
            return;
        }
        if (!hit)
            return;
        tally.hit_something += bounce == 0;
        ray = with_hit(ray, hit, scene, [&](const auto &surface) {
            const Vec<double> leave = surface.normal + uniform_direction(random); // the cosine law
            return Ray<double>{surface.point, leave, 1e-6};
        });
    }
}

// As many photons as asked for, drawn from one stream.
template <class ForwardScene> ForwardTally shoot_photons(const Vec<double> &light, const ForwardScene &scene,
                                                         const Sphere<> &pupil, int bounces, int photons,
                                                         std::uint64_t seed) {
    ForwardTally tally;
    Random random(seed);
    for (int i = 0; i < photons; ++i)
        shoot_photon(light, scene, pupil, bounces, random, tally);
    return tally;
}

} // namespace course
