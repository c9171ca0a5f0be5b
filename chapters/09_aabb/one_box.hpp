// Lesson 09, step 7: the two simplest structures, a list that tests everything and one box around the list.
#pragma once
#include "chapters/09_aabb/slab.hpp"
#include "chapters/09_aabb/structure.hpp"

namespace course {

// No acceleration at all: brute force under the contract of a structure.
template <Bounded S> struct PlainList {
    using Shape = S;

    ShapeList<Shape> shapes;
    Box<ScalarOfBounds<Shape>> box;

    explicit PlainList(std::span<const Shape> given) : shapes(given), box(bounds(given)) {}
    static std::size_t node_bytes() { return 0; }
};

template <class R, class Shape, class Test> void traverse(R &, const PlainList<Shape> &list, Test &&test) {
    for (Id slot = 0; slot < list.shapes.slots(); ++slot)
        if (test(slot))
            return;
}

// One box around all: a ray that misses it is spared every test, a ray that meets it pays one more.
template <Bounded S> struct OneBox {
    using Shape = S;

    ShapeList<Shape> shapes;
    Box<ScalarOfBounds<Shape>> box;

    explicit OneBox(std::span<const Shape> given) : shapes(given), box(bounds(given)) {}
    static std::size_t node_bytes() { return sizeof(box); }
};

template <class R, class Shape, class Test> void traverse(R &ray, const OneBox<Shape> &one, Test &&test) {
    ray.counts().node();
    if (!holds_any(one.box) || !SlabRay(ray, one.box).meets(one.box, static_cast<double>(ray.t_max)))
        return;
    for (Id slot = 0; slot < one.shapes.slots(); ++slot)
        if (test(slot))
            return;
}

} // namespace course
