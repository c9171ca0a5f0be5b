// Lesson 15, step 7: many rays in flight. While one waits for memory, the others have theirs.
#pragma once
#include "chapters/15_wide_bvh/fetch.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace course {

inline constexpr std::size_t rays_in_flight = 16;

// Takes rays through the tree, each one step at a time: a node or a leaf. Rays that stand before a node and rays that
// stand before a leaf are kept in two lists, so that a pass over a list never has to guess what comes, and every pass
// asks for the memory of the next one. A ray that is done makes room for another.
template <class T, WideOptions Options, std::size_t Width = rays_in_flight> class InFlight {
  public:
    using Bvh = WideBvhBy<Triangle<float>, Options>;

    explicit InFlight(const Bvh &bvh) : bvh_(bvh), flights_(new Flight[Width]) {}

    // Calls done(i, hit) once for each ray, in any order. With `any`, the first hit will do, wherever it is.
    template <class Done> void operator()(std::span<const Ray<T>> rays, bool any, Done &&done) {
        List idle, nodes, leaves;
        for (std::size_t i = 0; i < Width; ++i)
            idle.add(static_cast<Id>(i));
        std::size_t next = 0;
        while (true) {
            while (!idle.empty() && next < rays.size()) {
                Flight &flight = flights_[idle.back()];
                if (bvh_.tree.nodes.empty()) {
                    done(next++, Hit<T>{});
                    continue;
                }
                begin(flight, rays[next], next);
                ++next;
                nodes.add(idle.take_back());
            }
            if (nodes.empty() && leaves.empty())
                return;
            List *const into[] = {&nodes, &leaves, &idle};
            const List now = nodes.size() >= leaves.size() ? nodes.take_all() : List{};
            for (const Id number : now)
                into[step_at_node(flights_[number])]->add(number);
            if (!now.empty() && !nodes.empty() && leaves.size() < Width / 2) {
                finish(idle, done);
                continue;
            }
            for (const Id number : leaves.take_all())
                into[step_at_leaf(flights_[number], any)]->add(number);
            finish(idle, done);
        }
    }

  private:
    struct Flight {
        std::optional<Sheared<Ray<T>>> search;
        std::optional<WideRay> wide;
        float t_max;
        WideLink at;
        Hit<T> best;
        std::size_t index;
        bool reported = true;
        WideStack stack;
    };

    // Numbers of flights.
    class List {
      public:
        void add(Id number) { numbers_[size_++] = number; }
        Id back() const { return numbers_[size_ - 1]; }
        Id take_back() { return numbers_[--size_]; }
        List take_all() { return std::exchange(*this, List{}); }
        bool empty() const { return size_ == 0; }
        std::size_t size() const { return size_; }
        const Id *begin() const { return numbers_.data(); }
        const Id *end() const { return numbers_.data() + size_; }

      private:
        std::size_t size_ = 0;
        std::array<Id, Width> numbers_;
    };

    void begin(Flight &flight, const Ray<T> &ray, std::size_t index) const {
        flight.search.emplace(ray);
        flight.wide.emplace(flight.search->shear, ray, bvh_.tree.reach, Options.slab_pad);
        flight.t_max = flight.wide->t_max;
        flight.at = WideLink::node(0);
        flight.best = {};
        flight.index = index;
        flight.reported = false;
        flight.stack.clear();
    }

    // Both return what comes next: 0 a node, 1 a leaf, 2 nothing.
    unsigned step_at_node(Flight &flight) const {
        const WideNode &node = bvh_.tree.nodes[flight.at.first()];
        const auto [enter, met] = (*flight.wide)(node, flight.t_max);
        push_by_octant(flight.stack, node, flight.wide->octant, enter, met);
        return go_on(flight);
    }
    unsigned step_at_leaf(Flight &flight, bool any) const {
        closest_of_leaf<Options>(*flight.search, *flight.wide, bvh_.shapes, flight.at, flight.t_max, flight.best);
        if (any && flight.best)
            return 2;
        flight.t_max = flight.wide->scaled(static_cast<double>(flight.search->t_max));
        return go_on(flight);
    }

    unsigned go_on(Flight &flight) const {
        if (!flight.stack.pop(flight.at, flight.t_max))
            return 2;
        fetch(bvh_, flight.at);
        return flight.at.is_leaf();
    }

    template <class Done> void finish(const List &idle, Done &&done) {
        for (const Id number : idle)
            if (Flight &flight = flights_[number]; !flight.reported) {
                done(flight.index, flight.best);
                flight.reported = true;
            }
    }

    const Bvh &bvh_;
    std::unique_ptr<Flight[]> flights_;
};

} // namespace course
