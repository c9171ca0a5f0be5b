// Lesson 13, step 2: what of a shape lies in a cell, and the planes that a shape proposes.
#pragma once
#include "chapters/08_mesh/triangle.hpp"
#include "chapters/13_bsp_tree/polytope.hpp"

#include <limits>

namespace course {

// Between which heights over a plane something lies.
struct Heights {
    double low, high;
};

// Of a shape in general its box is known; a cut by a plane in any position would not leave a box, so none is made.
template <Bounded Shape> class Piece {
  public:
    Piece(const Shape &, const Box<float> &box) : box_{Vec<double>(box.lo), Vec<double>(box.hi)} {}

    // The corner of the box that lies highest is the middle, half an edge further on each axis.
    Heights over(const SplitPlane &plane) const {
        const double middle = plane.height(centre(box_));
        const double reach = dot(abs(Vec<double>(plane.normal)), 0.5 * extent(box_));
        return {middle - reach, middle + reach};
    }

    Piece part(const SplitPlane &, int) const { return *this; }
    Box<double> box() const { return box_; }

    template <class F> static void each_own_plane(const Shape &, F &&) {}

  private:
    Box<double> box_;
};

// A triangle is cut like any polygon, so the builder knows exactly which cells it reaches.
template <class S> class Piece<Triangle<S>> {
  public:
    Piece(const Triangle<S> &triangle, const Box<float> &) {
        const Vec<double> most(std::numeric_limits<float>::max()); // an infinite corner lies at the largest float
        for (const Vec<S> &corner : {triangle.a, triangle.b, triangle.c})
            polygon_.push_back(clamp(Vec<double>(corner), -most, most));
    }

    Heights over(const SplitPlane &plane) const {
        Heights heights{infinity<double>, -infinity<double>};
        for (const Vec<double> &p : polygon_) {
            const double height = plane.height(p);
            heights.low = std::min(heights.low, height);
            heights.high = std::max(heights.high, height);
        }
        return heights;
    }

    Piece part(const SplitPlane &plane, int side) const { return Piece(part_of(polygon_, plane, side)); }

    Box<double> box() const {
        Box<double> box = empty_box<double>();
        for (const Vec<double> &p : polygon_)
            box = merge(box, Box<double>{p, p});
        return box;
    }

    // Its own plane first, then those through its edges at right angles to it: each of them has the triangle on one
    // side, and if the surface is smooth, the neighbours on the other.
    template <class F> static void each_own_plane(const Triangle<S> &triangle, F &&f) {
        const Vec<double> a(triangle.a), b(triangle.b), c(triangle.c), normal = area_vector(triangle);
        f(plane_across(normal, a));
        f(plane_across(cross(normal, b - a), a));
        f(plane_across(cross(normal, c - b), b));
        f(plane_across(cross(normal, a - c), c));
    }

  private:
    explicit Piece(Polygon polygon) : polygon_(std::move(polygon)) {}

    Polygon polygon_;
};

template <class Shape, class Material> class Piece<Object<Shape, Material>> {
  public:
    using Inner = Piece<Shape>;
    Piece(const Object<Shape, Material> &object, const Box<float> &box) : inner_(object.shape, box) {}

    Heights over(const SplitPlane &plane) const { return inner_.over(plane); }
    Piece part(const SplitPlane &plane, int side) const { return Piece(inner_.part(plane, side)); }
    Box<double> box() const { return inner_.box(); }
    template <class F> static void each_own_plane(const Object<Shape, Material> &object, F &&f) {
        Inner::each_own_plane(object.shape, f);
    }

  private:
    explicit Piece(Inner inner) : inner_(std::move(inner)) {}

    Inner inner_;
};

} // namespace course
