// Lesson 02, step 13: a free-form surface that grows from eight drops into a cube of tubes.
#pragma once
#include "chapters/02_primitives/implicit.hpp"

namespace course {

// (x² - 1)² + (y² - 1)² + (z² - 1)² = level, with x, y, z counted from the centre in units of `size` (after Goursat,
// 1887). At level 0 it is the eight corners of a cube; they grow into drops, join at 1 along the edges, at 2 across the
// faces, and at 3 the hollow within is filled.
template <class S = float> struct LatticeBlob {
    Vec<S> centre;
    S size, level;

    template <class N> N operator()(const N &x, const N &y, const N &z) const {
        const Vec<double> c(centre);
        const double scale = 1 / static_cast<double>(size);
        const auto well = [scale](const N &coordinate, double middle) {
            return square(square(scale * (coordinate - middle)) - 1);
        };
        return well(x, c.x) + well(y, c.y) + well(z, c.z) - static_cast<double>(level);
    }
};

template <class S> Implicit<LatticeBlob<S>, S> shape_of(const LatticeBlob<S> &blob) {
    const double reach =
        1.001 * static_cast<double>(blob.size) * std::sqrt(1 + std::sqrt(static_cast<double>(blob.level)));
    return {blob, {Vec<S>(Vec<double>(blob.centre) - reach), Vec<S>(Vec<double>(blob.centre) + reach)}};
}

} // namespace course
