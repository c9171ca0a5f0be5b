// Lesson 01, step 4: the nearest of several hits, and who wins a tie.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"

#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace course {

// Which primitive was hit: its place in the scene's order, kept by every acceleration structure.
using Id = std::uint32_t;
inline constexpr Id no_id = ~Id{0};

// All that the search for the nearest hit carries; everything else is worked out once, for the hit that won.
template <class T> struct Hit {
    T t = infinity<T>;
    Id id = no_id;

    explicit operator bool() const { return id != no_id; }
};

// The order of hits: nearer first, and of two at the same t the lower id. Every structure keeps it, so that all return
// the same primitive where two surfaces coincide.
template <class T> bool comes_before(const Hit<T> &a, const Hit<T> &b) {
    return a.t < b.t || (a.t == b.t && a.id < b.id);
}

// The next larger number after a finite t >= 0.
template <class T> T next_up(T t) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    return std::bit_cast<T>(static_cast<Bits>(std::bit_cast<Bits>(t) + 1));
}

// A shape that one ray meets at one nearest t: it has an overload of intersect().
template <class Shape, class R>
concept Primitive = requires(const R &ray, const Shape &shape) {
    { intersect(ray, shape) } -> std::same_as<std::optional<typename R::Scalar>>;
};

// How many primitives a shape holds: one, unless a container or structure says otherwise by its own overload.
template <class Shape> constexpr Id size(const Shape &) { return 1; }

// The nearest hit of one primitive, with id 0. Scenes and structures have overloads under the same name.
template <class R, class Shape>
    requires Primitive<Shape, R> Hit<typename R::Scalar> closest_hit(const R &ray, const Shape &shape) {
        ray.counts().test();
        if (const auto t = intersect(ray, shape))
            return {*t, 0};
        return {};
    }

// Improves `best` by `shape`, whose first primitive has the id `base`. Only here is t_max narrowed, to the number after
// the best t: a later primitive at exactly the same t is still seen, and comes_before() settles the tie.
template <class R, class Shape> void closest_of(R &ray, const Shape &shape, Id base, Hit<typename R::Scalar> &best) {
    auto hit = closest_hit(ray, shape);
    if (!hit)
        return;
    hit.id += base;
    if (comes_before(hit, best)) {
        best = hit;
        ray.t_max = next_up(hit.t);
    }
}

} // namespace course
