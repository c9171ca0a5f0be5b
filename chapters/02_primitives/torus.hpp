// Lesson 02, step 12: a ring, of degree four.
#pragma once
#include "chapters/02_primitives/implicit.hpp"

namespace course {

// All points at distance `tube` from the circle of radius `ring` around the centre, in the plane perpendicular to the
// axis. With q = p - centre and h its height along the axis, (|q|² + ring² - tube²)² = 4 ring² (|q|² - h²).
template <class S = float> struct Torus {
    Vec<S> centre, axis; // the axis may have any length but zero
    S ring, tube;

    template <class N> N operator()(const N &x, const N &y, const N &z) const {
        const Vec<double> c(centre), a(axis);
        const double ring_squared = square(static_cast<double>(ring)), tube_squared = square(static_cast<double>(tube));
        const N qx = x - c.x, qy = y - c.y, qz = z - c.z;
        const N q_squared = square(qx) + square(qy) + square(qz), h = a.x * qx + a.y * qy + a.z * qz;
        return square(q_squared + (ring_squared - tube_squared)) -
               (4 * ring_squared) * (q_squared - (1 / dot(a, a)) * square(h));
    }
};

// The torus as a shape: a circle with the normal a reaches sqrt(1 - a_i²) of its radius along the axis i.
template <class S> Implicit<Torus<S>, S> shape_of(const Torus<S> &torus) {
    const Vec<double> a = normalize(Vec<double>(torus.axis));
    const Vec<double> reach = static_cast<double>(torus.ring) * sqrt(max(Vec<double>(0), 1.0 - a * a)) +
                              Vec<double>(1.001 * static_cast<double>(torus.tube));
    return {torus, {Vec<S>(Vec<double>(torus.centre) - reach), Vec<S>(Vec<double>(torus.centre) + reach)}};
}

} // namespace course
