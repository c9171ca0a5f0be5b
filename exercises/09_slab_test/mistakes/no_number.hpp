// Mistake: 0 / 0 is NaN in the plane of a face, and then the order of the arguments decides.
// Caught by: a ray along an axis is decided, also in the plane of a face
#pragma once
#include "exercises/09_slab_test/task.hpp"

namespace course::exercise {

inline bool meets_box(const Ray<double> &ray, const Box<float> &box) {
    double enter = ray.t_min, exit = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        const double lo = static_cast<double>(box.lo[axis]), hi = static_cast<double>(box.hi[axis]);
        const double t0 = (lo - o) / d, t1 = (hi - o) / d;
        enter = std::max(std::min(t0, t1), enter);
        exit = std::min(std::max(t0, t1), exit);
    }
    return enter <= exit;
}

inline constexpr Task task{meets_box};

} // namespace course::exercise
