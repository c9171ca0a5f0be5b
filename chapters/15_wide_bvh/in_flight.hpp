// Lesson 15, step 7: many rays in flight. While one waits for memory, the others have theirs.
#pragma once
#include "chapters/15_wide_bvh/fetch.hpp"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace course {

inline constexpr std::size_t rays_in_flight = 32;

// Takes rays through the tree, each one step at a time: a node or a leaf. Rays that stand before a node and rays that
// stand before a leaf are kept in two lists, so that a pass over a list never has to guess what comes, and every step
// asks for the memory of the ray's next one. A ray that is done makes room for another.
template <class T, WideOptions Options, std::size_t Width = rays_in_flight> class InFlight {
  public:
    using Bvh = WideBvhBy<Triangle<float>, Options>;

    explicit InFlight(const Bvh &bvh) : bvh_(bvh), flights_(new Flight[Width]) {}

    // Calls done(i, hit) once for each ray, in any order. With `any`, the first hit will do, wherever it is.
    template <class Done> void operator()(std::span<const Ray<T>> rays, bool any, Done &&done) {
        if (bvh_.tree.nodes.empty()) {
            for (std::size_t i = 0; i < rays.size(); ++i)
                done(i, Hit<T>{});
            return;
        }
        List nodes, leaves;
        std::size_t next = 0;
        for (; next < std::min(Width, rays.size()); ++next)
            begin(*nodes.add(&flights_[next]), rays[next], next);
        while (nodes.size() + leaves.size() != 0) {
            for (Flight *flight : nodes.take_all()) {
                step_at_node(*flight);
                nodes.add(flight, !flight->at.is_leaf());
                leaves.add(flight, flight->at.is_leaf());
            }
            if (nodes.size() > Width / 2)
                continue;
            for (Flight *flight : leaves.take_all()) {
                if (flight->at.is_end() || step_at_leaf(*flight, any)) {
                    done(flight->index, flight->search->closest());
                    if (next == rays.size())
                        continue;
                    begin(*flight, rays[next], next);
                    ++next;
                }
                nodes.add(flight, !flight->at.is_leaf());
                leaves.add(flight, flight->at.is_leaf());
            }
        }
    }

  private:
    struct Flight {
        std::optional<WideRay> wide;
        std::optional<TriangleSearch<Options, Ray<T>>> search;
        float t_max;
        WideLink at; // a leaf, a node or the end
        unsigned waiting;
        std::size_t index;
        WideStack stack;
    };

    // Flights; each is in one list at most.
    class List {
      public:
        // Without a branch: what is not wanted is written as well, and then written over.
        Flight *add(Flight *flight, bool wanted = true) {
            flights_[size_] = flight;
            size_ += wanted;
            return flight;
        }
        List take_all() { return std::exchange(*this, List{}); }
        std::size_t size() const { return size_; }
        Flight *const *begin() const { return flights_.data(); }
        Flight *const *end() const { return flights_.data() + size_; }

      private:
        std::size_t size_ = 0;
        std::array<Flight *, Width + 1> flights_;
    };

    void begin(Flight &flight, const Ray<T> &ray, std::size_t index) const {
        flight.wide.emplace(ray, bvh_.tree.reach, Options.slab_pad);
        flight.search.emplace(ray, *flight.wide, bvh_.shapes);
        flight.t_max = flight.wide->t_max;
        flight.at = WideLink::node(0);
        flight.waiting = flight.stack.push(0, WideLink::end(), -1);
        flight.index = index;
    }

    void step_at_node(Flight &flight) const {
        const WideNode &node = bvh_.tree.nodes[flight.at.first()];
        flight.waiting =
            push<Options>(flight.stack, flight.waiting, node, flight.wide->octant, (*flight.wide)(node, flight.t_max));
        go_on(flight);
    }
    // Returns whether the ray is done.
    bool step_at_leaf(Flight &flight, bool any) const {
        if (any) {
            const bool hit = flight.search->hits(flight.at);
            go_on(flight);
            return hit;
        }
        const float before = flight.t_max;
        flight.search->look(flight.at, flight.t_max);
        if (flight.t_max < before)
            flight.waiting = flight.stack.drop_beyond(flight.waiting, flight.t_max);
        go_on(flight);
        return false;
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
