// Mistake: the end of the ray is not looked at.
// Caught by: a box beyond t_max is not met
#pragma once
#include "exercises/09_slab_test/task.hpp"

namespace course::exercise {

inline bool meets_box(const Ray<double> &ray, const Box<float> &box) {
    double enter = ray.t_min, exit = infinity<double>;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        const double lo = static_cast<double>(box.lo[axis]), hi = static_cast<double>(box.hi[axis]);
        if (d == 0) {
            if (!(lo <= o && o <= hi))
                return false;
            continue;
        }
        const double t0 = (lo - o) / d, t1 = (hi - o) / d;
        enter = std::max(enter, std::min(t0, t1));
        exit = std::min(exit, std::max(t0, t1));
    }
    return enter <= exit;
}

inline constexpr Task task{meets_box};

} // namespace course::exercise
