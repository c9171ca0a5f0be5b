// Lesson 12, step 5: a ray and the planes across the axes, with room for rounding on both sides of each.
#pragma once
#include "chapters/09_aabb/slab.hpp"
#include "chapters/12_kd_tree/node.hpp"

#include <algorithm>
#include <cmath>

namespace course {

// A ray made ready for planes across the axes. Like SlabRay it takes the plane a margin later for what is before it,
// and a margin earlier for what is behind: around the plane the ray is on both sides. So a hit that rounding puts on
// the wrong side of a plane is found all the same, and nothing has to be listed twice for the sake of rounding.
class SplitRay {
  public:
    template <class T, class S> SplitRay(const Ray<T> &ray, const Box<S> &reach) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction), far = abs(origin);
        const double margin = (sizeof(T) == sizeof(float) ? 0x1p-20 : 0x1p-24) *
                              (std::max({far.x, far.y, far.z}) + largest_coordinate(reach));
        const double least = 0x1p-30 * std::max({size.x, size.y, size.z});
        for (int axis = 0; axis < 3; ++axis) {
            const double d = std::copysign(std::max(size[axis], least), direction[axis]), inverse = 1 / d;
            const double shift = std::copysign(margin, d);
            axes_[axis] = {inverse, (shift - origin[axis]) * inverse, (-shift - origin[axis]) * inverse,
                           std::signbit(d)};
        }
    }

    // The t by which the ray has surely left the side it comes from, the t before which it is surely still there, and
    // whether that side is the upper one.
    struct Crossing {
        double near_ends, far_begins;
        bool from_above;
    };
    Crossing operator()(int axis, double at) const {
        const Axis &a = axes_[axis];
        return {multiply_add(at, a.inverse, a.later), multiply_add(at, a.inverse, a.sooner), a.backwards};
    }

    // The part of `span` in a box: what is entered begins a margin before, what is left ends a margin after.
    Span within(const KdNode *sides, Span span) const {
        for (int axis = 0; axis < 3; ++axis) {
            const Axis &a = axes_[axis];
            const auto near = static_cast<double>(sides[axis].side(a.backwards));
            const auto far = static_cast<double>(sides[axis].side(!a.backwards));
            const double enter = multiply_add(near, a.inverse, a.sooner), exit = multiply_add(far, a.inverse, a.later);
            span.enter = enter > span.enter ? enter : span.enter; // NaN limits nothing
            span.exit = exit < span.exit ? exit : span.exit;
        }
        return span;
    }

  private:
    struct Axis {
        double inverse, later, sooner;
        bool backwards;
    };
    Axis axes_[3];
};

} // namespace course
