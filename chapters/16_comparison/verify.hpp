// Lesson 16, step 10: no time is shown before the answers were checked.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/16_comparison/rays.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace course {

// What a batch's rays really meet. For a shadow batch only whether there is a hit counts.
using Truth = std::vector<Hit<double>>;

// The answer of chapter 01's loop over all triangles.
inline Hit<double> brute_force(const TestRay &ray, const Scene<Triangle<>> &scene) {
    const Ray<double> plain{Vec<double>(ray.origin), Vec<double>(ray.direction), 0, static_cast<double>(ray.t_max)};
    return closest_hit(with_shear(plain), scene);
}

// Brute force for as many rays as `tests` allow, at equal distances in the batch: for every ray of a small scene. The
// others' answers come from `tracer`, which must be exact, and is itself compared with what brute force said.
inline Truth truth_of(const RayBatch &batch, const Scene<Triangle<>> &scene, const Contestant &tracer, double tests) {
    Truth truth(batch.rays.size());
    tracer.closest(batch.rays, truth);
    const double affordable = tests / static_cast<double>(size(scene)), all = static_cast<double>(batch.rays.size());
    const std::size_t step = affordable >= all ? 1 : static_cast<std::size_t>(all / std::max(affordable, 16.0)) + 1;
    for (std::size_t i = 0; i < batch.rays.size(); i += step)
        truth[i] = brute_force(batch.rays[i], scene);
    return truth;
}

// One of every `step` rays, at a place of its own in each stretch: at equal distances, a scene that repeats itself
// would always show the same side.
inline std::size_t place_in_stretch(std::size_t i, std::size_t step) {
    return i * step + (i * 0x9e3779b97f4a7c15u >> 32) % step;
}

// The rays that a contestant is given: one of every `step` of the batch.
struct Share {
    std::size_t step = 1;
    std::vector<TestRay> rays;
    std::vector<Hit<double>> found;
    std::vector<unsigned char> blocked;

    Share(const RayBatch &batch, std::size_t every) : step(every) {
        for (std::size_t i = 0; i < batch.rays.size() / step; ++i)
            rays.push_back(batch.rays[place_in_stretch(i, step)]);
        found.resize(rays.size());
        blocked.resize(rays.size());
    }

    void trace(const Contestant &contestant, bool shadow) {
        if (shadow)
            contestant.shadow(rays, blocked);
        else
            contestant.closest(rays, found);
    }
};

struct Verdict {
    std::size_t mismatches = 0; // another primitive or none; where answers must be exact, also another t
    std::size_t leaks = 0;      // a hit where there is none, or none where there is one
};

inline Verdict verdict_on(const Share &share, const Truth &truth, bool shadow, bool exact) {
    Verdict verdict;
    for (std::size_t i = 0; i < share.rays.size(); ++i) {
        const Hit<double> &right = truth[place_in_stretch(i, share.step)], &found = share.found[i];
        const bool leak = bool(right) != (shadow ? share.blocked[i] != 0 : bool(found));
        const bool other = !shadow && (right.id != found.id || (exact && right && right.t != found.t));
        verdict.leaks += leak;
        verdict.mismatches += leak || other;
    }
    return verdict;
}

} // namespace course
