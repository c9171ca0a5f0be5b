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
        axes_[0] = Axis(origin.x, std::copysign(std::max(size.x, least), direction.x), margin);
        axes_[1] = Axis(origin.y, std::copysign(std::max(size.y, least), direction.y), margin);
        axes_[2] = Axis(origin.z, std::copysign(std::max(size.z, least), direction.z), margin);
    }

    // The part of the ray in the box, up to t_max: every hit in the box with t_min < t < t_max has enter <= t <= exit.
    // Where enter > exit, there is none.
    template <class S> Span operator()(const Box<S> &box, double t_max = infinity<double>) const {
        Span span{t_min_, t_max};
        axes_[0].limit(span, static_cast<double>(box.lo.x), static_cast<double>(box.hi.x));
        axes_[1].limit(span, static_cast<double>(box.lo.y), static_cast<double>(box.hi.y));
        axes_[2].limit(span, static_cast<double>(box.lo.z), static_cast<double>(box.hi.z));
        return span;
    }

    template <class S> bool meets(const Box<S> &box, double t_max) const {
        const Span span = (*this)(box, t_max);
        return !(span.enter > span.exit);
    }

  private:
    // One pair of planes. A plane at x is met at x * inverse + shift.
    struct Axis {
        double inverse, near_shift, far_shift;
        bool backwards;

        Axis() = default;
        Axis(double origin, double direction, double margin)
            : inverse(1 / direction), backwards(std::signbit(direction)) {
            near_shift = -(origin + std::copysign(margin, direction)) * inverse;
            far_shift = -(origin - std::copysign(margin, direction)) * inverse;
        }

        // The comparisons drop a NaN, which then limits nothing.
        void limit(Span &span, double lo, double hi) const {
            const double near = multiply_add(backwards ? hi : lo, inverse, near_shift);
            const double far = multiply_add(backwards ? lo : hi, inverse, far_shift);
            span.enter = near > span.enter ? near : span.enter;
            span.exit = far < span.exit ? far : span.exit;
        }
    };

    double t_min_;
    Axis axes_[3];
};

} // namespace course
