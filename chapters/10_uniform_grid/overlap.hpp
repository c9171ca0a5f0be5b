// Lesson 10, step 1: does a shape reach into a box? For a triangle exactly, with thirteen directions to look from.
#pragma once
#include "chapters/09_aabb/bounds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace course {

// How large a shape is to a division of space: its widths, the areas of its shadows along each axis, its volume.
struct Footprint {
    Vec<double> widths{0}, shadows{0};
    double volume = 0;

    Footprint &operator+=(const Footprint &other) {
        widths += other.widths;
        shadows += other.shadows;
        volume += other.volume;
        return *this;
    }
};

inline Footprint footprint_of(const Vec<double> &e) { return {e, {e.y * e.z, e.z * e.x, e.x * e.y}, e.x * e.y * e.z}; }

// Overlap<Shape>(shape)(box): whether the shape may have a point in the box. False only when it surely has none; also
// with NaN it errs to that side. In general the answer is that of the shape's box.
template <Bounded Shape> class Overlap {
  public:
    explicit Overlap(const Shape &shape) : own_(rounded_outward<double>(bounds(shape))) {}

    bool operator()(const Box<double> &box) const {
        const Box<double> common = common_part(own_, box);
        return !(common.lo.x > common.hi.x || common.lo.y > common.hi.y || common.lo.z > common.hi.z);
    }

    Footprint footprint() const { return footprint_of(extent(own_)); }

  private:
    Box<double> own_;
};

// Two convex bodies are apart exactly if they look apart from somewhere: if, projected onto some line, one ends before
// the other begins. For a triangle and a box thirteen lines are enough: the three axes, the triangle's normal, and the
// nine vectors at right angles to an edge of each (Akenine-Möller 2001). Which line is asked cannot make the answer
// wrong, so the rounding of the normal does not matter; boxes come with a margin that covers the rounding of the sums.
template <class S> class Overlap<Triangle<S>> {
  public:
    explicit Overlap(const Triangle<S> &triangle) : own_(rounded_outward<double>(bounds(triangle))), a_(triangle.a) {
        p_ = Vec<double>(triangle.b) - a_;
        q_ = Vec<double>(triangle.c) - a_;
        lines_[0].direction = area_vector(triangle);
        std::size_t next = 1;
        for (const Vec<double> &edge : {p_, q_, q_ - p_}) {
            lines_[next++].direction = {0, edge.z, -edge.y}; // the cross products of the edge with the axes
            lines_[next++].direction = {-edge.z, 0, edge.x};
            lines_[next++].direction = {edge.y, -edge.x, 0};
        }
        for (Line &line : lines_) { // where the triangle lies on the line, counted from the corner a
            const double b = dot(line.direction, p_), c = dot(line.direction, q_);
            line.lo = std::min({0.0, b, c});
            line.hi = std::max({0.0, b, c});
        }
    }

    bool operator()(const Box<double> &box) const {
        for (int axis = 0; axis < 3; ++axis)
            if (own_.lo[axis] > box.hi[axis] || own_.hi[axis] < box.lo[axis])
                return false;
        const Vec<double> middle = centre(box) - a_, half = 0.5 * extent(box);
        for (const Line &line : lines_) {
            const double at = dot(line.direction, middle), reach = dot(abs(line.direction), half);
            if (at - reach > line.hi || at + reach < line.lo)
                return false;
        }
        return true;
    }

    // A triangle is flat: it has shadows but no volume.
    Footprint footprint() const { return {extent(own_), 0.5 * abs(lines_[0].direction), 0}; }

  private:
    struct Line {
        Vec<double> direction{0};
        double lo = 0, hi = 0;
    };
    Box<double> own_;
    Vec<double> a_, p_, q_;
    std::array<Line, 10> lines_;
};

// The surface of a sphere, not the ball: the nearest point of the box must lie within, the farthest without.
template <class S> class Overlap<Sphere<S>> {
  public:
    explicit Overlap(const Sphere<S> &sphere)
        : centre_(sphere.centre), radius_(sphere.radius), own_(rounded_outward<double>(bounds(sphere))) {}

    bool operator()(const Box<double> &box) const {
        const Vec<double> near = clamp(centre_, box.lo, box.hi) - centre_;
        const Vec<double> far = max(abs(box.lo - centre_), abs(box.hi - centre_));
        return !(dot(near, near) > radius_ * radius_ * (1 + 1e-12) || dot(far, far) < radius_ * radius_ * (1 - 1e-12));
    }

    Footprint footprint() const { return footprint_of(extent(own_)); }

  private:
    Vec<double> centre_;
    double radius_;
    Box<double> own_;
};

template <class Shape, class Material> class Overlap<Object<Shape, Material>> : public Overlap<Shape> {
  public:
    explicit Overlap(const Object<Shape, Material> &object) : Overlap<Shape>(object.shape) {}
};

} // namespace course
