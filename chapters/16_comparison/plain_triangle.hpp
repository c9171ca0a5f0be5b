// Lesson 16, step 1: the triangle that a textbook tracer has, in the same structures: how much of the speed is honesty?
#pragma once
#include "chapters/08_mesh/moller_trumbore.hpp"
#include "chapters/09_aabb/bounds.hpp"
#include "chapters/10_uniform_grid/overlap.hpp"
#include "chapters/13_bsp_tree/piece.hpp"

#include <optional>

namespace course {

// A triangle whose default test is chapter 08's Möller–Trumbore in the ray's own scalar. With float rays that is what
// most tracers do: fast, and wrong now and then. Structures treat it like the triangle that it is.
template <class S = float> struct PlainTriangle : Triangle<S> {};

template <class T, class S> std::optional<T> intersect(const Ray<T> &ray, const PlainTriangle<S> &triangle) {
    return moller_trumbore(ray, static_cast<const Triangle<S> &>(triangle));
}

template <class S> Box<S> bounds(const PlainTriangle<S> &triangle) {
    return bounds(static_cast<const Triangle<S> &>(triangle));
}

// Structures that cut space ask which cells it touches: those of the triangle.
template <class S> class Overlap<PlainTriangle<S>> : public Overlap<Triangle<S>> {
  public:
    using Overlap<Triangle<S>>::Overlap;
};

// And a BSP-tree cuts it like the triangle, and takes planes from it.
template <class S> class Piece<PlainTriangle<S>> : public Piece<Triangle<S>> {
  public:
    using Piece<Triangle<S>>::Piece;
    Piece part(const SplitPlane &plane, int side) const { return Piece(Piece<Triangle<S>>::part(plane, side)); }

  private:
    explicit Piece(const Piece<Triangle<S>> &part) : Piece<Triangle<S>>(part) {}
};

} // namespace course
