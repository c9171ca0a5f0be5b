// Lesson 15, step 7: many rays in flight. While one waits for memory, the others have theirs.
#pragma once
#include "chapters/15_wide_bvh/fetch.hpp"
#include "chapters/15_wide_bvh/flight_list.hpp"

#include <memory>
#include <optional>
#include <span>
#include <type_traits>

namespace course {

inline constexpr std::size_t rays_in_flight = 32;

// Takes rays through the tree, each one step at a time: a node or a leaf. Rays that stand before a node, rays that
// stand before a leaf and rays that have landed are kept in three lists, so that a pass over a list never has to guess
// what comes, and every step asks for the memory of the ray's next one. A ray that has landed makes room for another.
template <class T, WideOptions Options, std::size_t Width = rays_in_flight> class InFlight {
  public:
    using Bvh = WideBvhBy<Triangle<float>, Options>;

    explicit InFlight(const Bvh &bvh) : bvh_(bvh), flights_(new Flight[Width]) {}

    // Calls done(i, hit) once for each ray, in any order. With `any`, the first hit will do, wherever it is.
    template <class Done> void operator()(std::span<const Ray<T>> rays, bool any, Done &&done) {
        (*this)(
            rays.size(), [&](std::size_t i) -> const Ray<T> & { return rays[i]; }, any, done);
    }
    // The same for rays that are made when their turn comes: ray_at(i) is called for each i below `count`, in that
    // order.
    template <class RayAt, class Done> void operator()(std::size_t count, const RayAt &ray_at, bool any, Done &&done) {
        if (bvh_.tree.nodes.empty())
            for (std::size_t i = 0; i < count; ++i)
                done(i, Hit<T>{});
        else if (any)
            fly<true>(count, ray_at, done);
        else
            fly<false>(count, ray_at, done);
    }

  private:
    template <bool Any, class RayAt, class Done> void fly(std::size_t count, const RayAt &ray_at, Done &done) {
        FlightList<Flight, Width> nodes, leaves, landed;
        const auto sort = [&](Flight &flight) {
            nodes.add(flight, !flight.at.is_leaf());
            leaves.add(flight, flight.at.is_leaf() && !flight.at.is_end());
            landed.add(flight, flight.at.is_end());
        };
        std::size_t next = 0;
        const auto begin_next = [&](Flight &flight) {
            begin(flight, ray_in(flight, ray_at, next), next);
            ++next;
            nodes.add(flight);
        };
        while (next < std::min(Width, count))
            begin_next(flights_[next]);
        while (nodes.size() + leaves.size() + landed.size() != 0) {
            nodes.for_each_anew([&](Flight &flight) {
                step_at_node<Any>(flight);
                sort(flight);
            });
            if (nodes.size() > Width / 2)
                continue;
            leaves.for_each_anew([&](Flight &flight) {
                step_at_leaf<Any>(flight);
                sort(flight);
            });
            landed.for_each_anew([&](Flight &flight) {
                done(flight.index, flight.search->closest());
                if (next < count)
                    begin_next(flight);
            });
        }
    }

    struct Flight {
        Ray<T> ray; // if it was made for this flight
        std::optional<WideRay> wide;
        std::optional<TriangleSearch<Options, Ray<T>>> search;
        float t_max;
        WideLink at; // a leaf, a node or the end
        unsigned waiting;
        std::size_t index;
        WideStack stack;
    };

    // A ray that is made now is made where it will stay: a copy would wait for what was stored in pieces just before.
    template <class RayAt> static const Ray<T> &ray_in(Flight &flight, const RayAt &ray_at, std::size_t i) {
        if constexpr (std::is_reference_v<decltype(ray_at(i))>)
            return ray_at(i);
        else
            return *std::construct_at(&flight.ray, ray_at(i));
    }

    void begin(Flight &flight, const Ray<T> &ray, std::size_t index) const {
        flight.wide.emplace(ray, bvh_.tree.reach, Options.slab_pad);
        flight.search.emplace(ray, *flight.wide, bvh_.shapes);
        flight.t_max = flight.wide->t_max;
        flight.at = WideLink::node(0);
        flight.waiting = flight.stack.push(0, WideLink::end(), -1);
        flight.index = index;
    }

    // A shadow ray does not care what comes first.
    template <bool Any> void step_at_node(Flight &flight) const {
        const WideNode &node = bvh_.tree.nodes[flight.at.first()];
        const Slabs<float> &boxes = flight.wide->boxes;
        const auto entries = boxes(node, flight.t_max);
        if constexpr (Any)
            flight.waiting = flight.stack.push(flight.waiting, load<Ints>(node.links), entries.met());
        else
            flight.waiting = push<Options>(flight.stack, flight.waiting, node, boxes.octant, entries);
        go_on(flight);
    }
    template <bool Any> void step_at_leaf(Flight &flight) const {
        if constexpr (Any) {
            if (flight.search->hits(flight.at))
                flight.waiting = 1; // only the end is left
        } else {
            const float before = flight.t_max;
            flight.search->look(flight.at, flight.t_max);
            if (flight.t_max < before)
                flight.waiting = flight.stack.drop_beyond(flight.waiting, flight.t_max);
        }
        go_on(flight);
    }
    void go_on(Flight &flight) const {
        flight.at = flight.stack[--flight.waiting];
        fetch_(flight.at);
    }

    const Bvh &bvh_;
    const Fetch<Options> fetch_{bvh_};
    std::unique_ptr<Flight[]> flights_;
};

} // namespace course
