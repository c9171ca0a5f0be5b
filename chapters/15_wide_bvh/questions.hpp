// Lesson 15, step 11: what shading asks of a scene, noted down, so that many rays can be traced together.
#pragma once
#include "chapters/15_wide_bvh/batch.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace course {

// Shadow rays from what a bounce ray has met go all ways, unlike those from what is seen.
enum RayKind : std::size_t { camera_rays, shadow_rays, bounce_rays, far_shadow_rays, ray_kinds };
inline bool wants_any(RayKind kind) { return kind == shadow_rays || kind == far_shadow_rays; }

// What the pixels of a tile ask of a scene. A question that cannot be answered yet is noted down. A pixel is shaded
// again and again, with ever more answers, until it has no question left. So any shading will do that asks
// closest_hit() and any_hit(), with two conditions: it asks the same again if it is told the same, and which rays
// follow does not depend on what a shadow ray finds.
class Questions {
  public:
    explicit Questions(std::size_t pixels) : told_(pixels) {
        for (auto &told : told_)
            told.reserve(8);
    }

    // What follows is asked by this pixel, from the beginning.
    void begin(std::size_t pixel) {
        pixel_ = pixel;
        asked_ = surfaces_ = 0;
        waits_ = false;
    }
    // Whether it had all the answers that it asked for.
    bool has_all() const { return asked_ <= told_[pixel_].size(); }

    Hit<double> ask(const Ray<double> &ray, bool any) {
        const std::size_t number = asked_++;
        surfaces_ += !any;
        if (number < told_[pixel_].size())
            return told_[pixel_][number];
        if (!waits_)
            open_[2 * (surfaces_ > 1) + any].add(ray, {pixel_, number});
        waits_ |= !any; // what comes after a closest hit may depend on it
        return {};
    }

    // Calls trace(kind, rays) for what was asked of each kind: it returns the hits.
    template <class Trace> void answer_all(const Trace &trace) {
        for (std::size_t kind = 0; kind < ray_kinds; ++kind) {
            const List list = std::exchange(open_[kind], {});
            const std::vector<Hit<double>> hits = trace(static_cast<RayKind>(kind), Batch(list.rays));
            for (std::size_t i = 0; i < hits.size(); ++i) {
                auto &told = told_[list.places[i].pixel];
                told.resize(std::max(told.size(), list.places[i].number + 1));
                told[list.places[i].number] = hits[i];
            }
        }
    }

  private:
    struct Place {
        std::size_t pixel, number; // the number of the question among the pixel's
    };
    struct List {
        std::vector<Ray<double>> rays;
        std::vector<Place> places;

        void add(const Ray<double> &ray, const Place &place) {
            rays.push_back(ray);
            places.push_back(place);
        }
    };

    std::vector<std::vector<Hit<double>>> told_; // by pixel
    std::array<List, ray_kinds> open_;
    std::size_t pixel_ = 0, asked_ = 0, surfaces_ = 0; // surfaces: how many closest hits were asked for
    bool waits_ = false;
};

// Stands in for the scene while a pixel is shaded.
template <class AnyScene> struct Deferred {
    const AnyScene &scene;
    Questions &questions;
};

template <class AnyScene> Hit<double> closest_hit(const Ray<double> &ray, const Deferred<AnyScene> &deferred) {
    return deferred.questions.ask(ray, false);
}
template <class AnyScene> bool any_hit(const Ray<double> &ray, const Deferred<AnyScene> &deferred) {
    return bool(deferred.questions.ask(ray, true));
}
template <class AnyScene, class F>
auto with_hit(const Ray<double> &ray, const Hit<double> &hit, const Deferred<AnyScene> &deferred, F &&f) {
    return with_hit(ray, hit, deferred.scene, f);
}

} // namespace course
