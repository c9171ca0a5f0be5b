// Lesson 02, beside the way: the obvious search for a root, which steps over some.
#pragma once
#include "chapters/02_primitives/implicit.hpp"

namespace course {

// Walks through the box in equal steps and looks for a change of sign, then bisects. Two roots within one step are
// never seen; the more steps, the fewer are lost, and none of them is the last.
template <class T, class F, class S>
std::optional<T> intersect_marching(const Ray<T> &ray, const Implicit<F, S> &shape, int steps) {
    const Span span = span_within(ray, shape.bounds);
    const double enter = std::max(span.enter, static_cast<double>(ray.t_min));
    if (!(enter <= span.exit && span.exit < infinity<double>))
        return {};
    const Vec<double> o(ray.origin), d(ray.direction);
    const auto inside = [&](double t) { return shape.f(o.x + d.x * t, o.y + d.y * t, o.z + d.z * t) < 0; };

    const double step = (span.exit - enter) / steps;
    const bool start = inside(enter);
    for (int i = 1; i <= steps; ++i) {
        if (inside(enter + i * step) == start)
            continue;
        double before = enter + (i - 1) * step, after = enter + i * step;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (before + after);
            (inside(middle) == start ? before : after) = middle;
        }
        const T t = static_cast<T>(after);
        return in_range(ray, t) ? std::optional(t) : std::nullopt;
    }
    return {};
}

} // namespace course
