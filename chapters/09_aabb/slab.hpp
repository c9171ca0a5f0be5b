// Lesson 09, step 2: does a ray pass through a box? As the notes print it, and so that no hit is ever lost.
#pragma once
#include "chapters/09_aabb/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace course {

// The slab test as B §4 and C print it, in the ray's scalar throughout: enter < exit loses every flat box, and where
// the ray lies in the plane of a face, 0 · infinity makes a NaN that lets the whole comparison fail.
template <class T, class S> bool meets_textbook(const Ray<T> &ray, const Box<S> &box) {
    const Vec<T> t0 = (Vec<T>(box.lo) - ray.origin) / ray.direction, t1 = (Vec<T>(box.hi) - ray.origin) / ray.direction;
    const Vec<T> near = min(t0, t1), far = max(t0, t1);
    const T enter = std::max({near.x, near.y, near.z}), exit = std::min({far.x, far.y, far.z});
    return enter < exit && exit >= 0;
}

// x y + z, rounded once where the processor can, twice elsewhere: only for bounds that have room for either.
inline double multiply_add(double x, double y, double z) {
#ifdef __FMA__
    return std::fma(x, y, z);
#else
    return x * y + z;
#endif
}

// A ray made ready for the boxes of one structure. It answers for whatever a box holds: no primitive in the box that
// intersect() reports a hit on is ever culled, neither by rounding here nor by rounding in intersect().
//
// Instead of one ray it follows two, a margin apart: planes that are entered are met by a ray that starts a little
// further on, planes that are left by one that starts a little behind (Ize 2013 widens t instead, which is too little
// where origin and plane are both 0). The margin is 2^-24 of the largest number around, for float rays 2^-20: wide
// against the error of any t that the default tests report, narrow against the parts of a scene.
class SlabRay {
  public:
    // `reach` holds every box that will be asked for.
    template <class T, class S> SlabRay(const Ray<T> &ray, const Box<S> &reach)
        : t_min_(static_cast<double>(ray.t_min)) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction), place = abs(origin);
        const double margin = (sizeof(T) == sizeof(float) ? 0x1p-20 : 0x1p-24) *
                              (std::max({place.x, place.y, place.z}) + largest_coordinate(reach));
        // A component that is 0 or nearly so becomes a very small one. Within reach the ray is moved by less than the
        // margin, and no 0 / 0 and no infinity - infinity can arise.
        const double least = 0x1p-30 * std::max({size.x, size.y, size.z});
        for (int axis = 0; axis < 3; ++axis) {
            const double d = std::copysign(std::max(size[axis], least), direction[axis]), inverse = 1 / d;
            backwards_[axis] = std::signbit(d);
            inverse_[axis] = inverse;
            near_shift_[axis] = -(origin[axis] + std::copysign(margin, d)) * inverse;
            far_shift_[axis] = -(origin[axis] - std::copysign(margin, d)) * inverse;
        }
    }

    // The part of the ray in the box, up to t_max: every hit in the box with t_min < t < t_max has enter <= t <= exit.
    // Where enter > exit, there is none. The comparisons drop a NaN, which then limits nothing.
    template <class S> Span operator()(const Box<S> &box, double t_max = infinity<double>) const {
        double enter = t_min_, exit = t_max;
        for (int axis = 0; axis < 3; ++axis) {
            const double lo = static_cast<double>(box.lo[axis]), hi = static_cast<double>(box.hi[axis]);
            const double near = multiply_add(backwards_[axis] ? hi : lo, inverse_[axis], near_shift_[axis]);
            const double far = multiply_add(backwards_[axis] ? lo : hi, inverse_[axis], far_shift_[axis]);
            enter = near > enter ? near : enter;
            exit = far < exit ? far : exit;
        }
        return {enter, exit};
    }

    template <class S> bool meets(const Box<S> &box, double t_max) const {
        const Span span = (*this)(box, t_max);
        return !(span.enter > span.exit);
    }

  private:
    double t_min_;
    bool backwards_[3];
    double inverse_[3], near_shift_[3], far_shift_[3];
};

} // namespace course
