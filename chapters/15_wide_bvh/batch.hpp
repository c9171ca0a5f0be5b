// Lesson 15, step 10: a batch of rays through a scene, one by one, in packets or in flight.
#pragma once
#include "chapters/09_aabb/accelerate.hpp"
#include "chapters/15_wide_bvh/in_flight.hpp"
#include "chapters/15_wide_bvh/packet.hpp"

namespace course {

enum class Way { one_by_one, packets, in_flight };
inline constexpr std::array all_ways{Way::one_by_one, Way::packets, Way::in_flight};

using Batch = std::span<const Ray<double>>;

// Calls done(i, hit) with the closest hit of every ray, or with some hit; the hits are the same whatever the way.
template <WideOptions Options, class Done>
void trace(Way way, Batch rays, bool any, const WideBvhBy<Triangle<float>, Options> &bvh, const Done &done) {
    if (way == Way::in_flight) {
        InFlight<double, Options> flights(bvh);
        flights(rays, any, done);
        return;
    }
    for (std::size_t first = 0; first < rays.size(); first += lanes) {
        const Batch some = rays.subspan(first, std::min<std::size_t>(lanes, rays.size() - first));
        std::array<Hit<double>, lanes> hits;
        std::array<bool, lanes> blocked;
        if (way == Way::packets && any)
            any_hits(some, bvh, std::span(blocked).first(some.size()));
        else if (way == Way::packets)
            closest_hits(some, bvh, std::span(hits).first(some.size()));
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (any)
                hits[i].id = (way == Way::packets ? blocked[i] : any_hit(some[i], bvh)) ? 0 : no_id;
            else if (way == Way::one_by_one)
                hits[i] = closest_hit(some[i], bvh);
            done(first + i, hits[i]);
        }
    }
}
template <WideOptions Options, class Material, class Done> void
trace(Way way, Batch rays, bool any, const Object<WideBvhBy<Triangle<float>, Options>, Material> &o, const Done &done) {
    trace(way, rays, any, o.shape, done);
}

template <class Shape>
concept TakesBatches = requires(const Shape &shape, Batch rays) {
    trace(Way{}, rays, true, shape, [](auto, auto) {});
};

// The hits of the rays in the scene, as closest_hit() and any_hit() find them. Where the scene holds a wide BVH, the
// rays go through it together; whatever else it holds is asked ray by ray.
template <class... Shapes>
std::vector<Hit<double>> hits_of(Way way, Batch rays, bool any, const Scene<Shapes...> &scene) {
    std::vector<Ray<double>> searches(rays.begin(), rays.end());
    std::vector<Hit<double>> best(rays.size());
    Id base = 0;
    for_each_shape(scene, [&](const auto &shape) {
        if constexpr (TakesBatches<std::remove_cvref_t<decltype(shape)>>)
            trace(way, searches, any, shape, [&](std::size_t i, Hit<double> hit) {
                hit.id += hit ? base : 0;
                if (hit && comes_before(hit, best[i])) {
                    best[i] = hit;
                    if (!any) // some hit has no t
                        searches[i].t_max = next_up(hit.t);
                }
            });
        else
            for (std::size_t i = 0; i < searches.size(); ++i)
                if (!any)
                    closest_of(searches[i], shape, base, best[i]);
                else if (!best[i] && any_hit(searches[i], shape))
                    best[i].id = base;
        base += size(shape);
    });
    return best;
}

} // namespace course
