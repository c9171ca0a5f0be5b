// Lesson 09, step 9: one mesh, standing in many places.
#pragma once
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "chapters/09_aabb/bounds.hpp"

namespace course {

// A linear map and a shift, in double: p' = columns * p + shift. The map may turn, stretch and mirror; it must be
// invertible.
struct Placement {
    glm::dmat3 linear{1.0}, inverse{1.0};
    Vec<double> shift{0};
};

inline Placement moved_by(const Vec<double> &shift) { return {glm::dmat3(1.0), glm::dmat3(1.0), shift}; }

inline Placement placed_by(const glm::dmat3 &linear, const Vec<double> &shift) {
    return {linear, glm::inverse(linear), shift};
}

// A shape seen through a placement. It points to the shape, which must outlive it: a hundred instances of a mesh cost a
// hundred placements and one mesh.
template <class Shape> struct Instance {
    const Shape *shape;
    Placement placement;
};

// Instead of moving the shape to the world, move the ray to the shape. The direction keeps the length that the map
// gives it, so t means the same on both sides, and hits of different instances compare.
template <class R> R into(const R &ray, const Placement &placement) {
    using T = typename R::Scalar;
    R local = ray;
    local.origin = Vec<T>(placement.inverse * (Vec<double>(ray.origin) - placement.shift));
    local.direction = Vec<T>(placement.inverse * Vec<double>(ray.direction));
    return local;
}

template <class Shape> Id size(const Instance<Shape> &instance) { return size(*instance.shape); }

template <class R, class Shape> Hit<typename R::Scalar> closest_hit(const R &ray, const Instance<Shape> &instance) {
    return closest_hit(into(ray, instance.placement), *instance.shape);
}

template <class R, class Shape> bool any_hit(const R &ray, const Instance<Shape> &instance) {
    return any_hit(into(ray, instance.placement), *instance.shape);
}

// The box around the eight moved corners, taken axis by axis: each coordinate of the image is a sum of three terms,
// each largest at one end of its interval (Arvo 1990).
template <class Shape> auto bounds(const Instance<Shape> &instance) -> decltype(bounds(*instance.shape)) {
    const auto local = bounds(*instance.shape);
    if (!holds_any(local))
        return local;
    Vec<double> lo = instance.placement.shift, hi = lo;
    for (int i = 0; i < 3; ++i) {
        const Vec<double> column = instance.placement.linear[i];
        const Vec<double> a = static_cast<double>(local.lo[i]) * column, b = static_cast<double>(local.hi[i]) * column;
        lo += min(a, b);
        hi += max(a, b);
    }
    return rounded_outward<std::remove_cvref_t<decltype(local.lo.x)>>(lo, hi);
}

template <class Shape> inline constexpr bool is_bounded<Instance<Shape>> = is_bounded<Shape>;

// The surface's shape as the world sees it: what asks the shape for more finds the shape and the way to it.
template <class Shape> struct Placed {
    const Shape &shape;
    const Placement &placement;
};

template <class Shape> double spawn_offset(const Placed<Shape> &placed, const Vec<double> &point) {
    const Vec<double> local = placed.placement.inverse * (point - placed.placement.shift);
    double stretch = 0; // an upper bound of how much the map lengthens a vector
    for (int i = 0; i < 3; ++i)
        stretch += length(placed.placement.linear[i]);
    return 4 * stretch * spawn_offset(placed.shape, local) + rounding_bound(point, placed.placement.shift);
}

template <class R, class Shape, class F, class... Context>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const Instance<Shape> &instance, F &&f,
              const Context &...context) {
    const Placement &placement = instance.placement;
    const auto in_world = [&](const auto &surface, const auto &...more) {
        using T = typename R::Scalar;
        using Local = std::remove_cvref_t<decltype(surface.shape)>;
        // A normal goes with the inverse's transpose; a mirroring map turns inside out what it moves, not the normal.
        const Vec<double> normal = normalize(transpose(placement.inverse) * Vec<double>(surface.normal));
        const Vec<double> point = placement.linear * Vec<double>(surface.point) + placement.shift;
        const Placed<Local> placed{surface.shape, placement};
        return f(Surface<T, Placed<Local>>{Vec<T>(point), Vec<T>(normal), placed, surface.id}, more...);
    };
    return with_hit(into(ray, placement), hit, *instance.shape, in_world, context...);
}

} // namespace course
