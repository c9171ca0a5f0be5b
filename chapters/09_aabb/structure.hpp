// Lesson 09, step 6: what an acceleration structure is. Chapters 10 to 15 each add one; README.md says how.
#pragma once
#include "chapters/09_aabb/bounds.hpp"
#include "chapters/09_aabb/prepared.hpp"
#include "chapters/09_aabb/shape_list.hpp"

#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace course {

// A structure X over a Shape is made from the shapes, X(std::span<const Shape>), and has:
//   shapes        the ShapeList with the primitives in the structure's order
//   box           the box around them
//   node_bytes()  the memory of everything but the shapes
// and, found by overload,
//   traverse(ray, structure, test)
// which calls test(slot) for every shape that the ray may hit within its interval: each at least once, near ones first
// if the structure can. test() returns true to end the walk; it narrows ray.t_max when it has found a hit, so a walk
// looks at ray.t_max again before each step, and leaves out what begins beyond it.
template <class X>
concept Structure = requires(const X &structure) {
    typename X::Shape;
    requires Bounded<typename X::Shape>;
    { structure.shapes } -> std::convertible_to<const ShapeList<typename X::Shape> &>;
    structure.box.lo;
    { structure.node_bytes() } -> std::same_as<std::size_t>;
};

// All else follows, the same for every structure, so that every structure keeps the same contract: the same id and the
// same t, bit for bit, as the loop over all shapes. And a structure is a shape, so structures nest.

template <Structure X> Id size(const X &structure) { return structure.shapes.primitives(); }

template <Structure X> auto bounds(const X &structure) { return structure.box; }

template <Structure X> std::size_t bytes(const X &structure) {
    return structure.shapes.bytes() + structure.node_bytes();
}

// What a search does with a shape: one function with the shape's test inside, which a walk calls.
template <class R, class Shape> [[gnu::flatten, gnu::noinline]] void try_slot(R &search, const ShapeList<Shape> &shapes,
                                                                              Id slot, Hit<typename R::Scalar> &best) {
    closest_of(search, shapes[slot], shapes.first_id(slot), best);
}

template <class R, Structure X> Hit<typename R::Scalar> closest_hit(const R &ray, const X &structure) {
    Hit<typename R::Scalar> best;
    auto search = prepared<typename X::Shape>(ray);
    traverse(search, structure, [&](Id slot) {
        try_slot(search, structure.shapes, slot, best);
        return false;
    });
    return best;
}

template <class R, class Shape>
[[gnu::flatten, gnu::noinline]] bool is_hit(const R &search, const ShapeList<Shape> &shapes, Id slot) {
    return any_hit(search, shapes[slot]);
}

template <class R, Structure X> bool any_hit(const R &ray, const X &structure) {
    bool found = false;
    auto search = prepared<typename X::Shape>(ray);
    traverse(search, structure, [&](Id slot) { return found = is_hit(search, structure.shapes, slot); });
    return found;
}

template <class R, Structure X, class F, class... Context>
auto with_hit(const R &ray, const Hit<typename R::Scalar> &hit, const X &structure, F &&f, const Context &...context) {
    const auto [slot, local_id] = structure.shapes.find(hit.id);
    return with_hit(ray, Hit<typename R::Scalar>{hit.t, local_id}, structure.shapes[slot], f, context...);
}

// ---- For builders ---------------------------------------------------------------------------------------------------

// The box of each shape in float, as most structures store it. Finite (but for NaN): infinite sides are pulled in to
// the largest float. Differences of such numbers may still overflow.
template <Bounded Shape> std::vector<Box<float>> float_boxes(std::span<const Shape> shapes) {
    const Vec<float> largest(std::numeric_limits<float>::max());
    std::vector<Box<float>> boxes;
    boxes.reserve(shapes.size());
    for (const Shape &shape : shapes) {
        const auto box = rounded_outward<float>(bounds(shape));
        boxes.push_back({clamp(box.lo, -largest, largest), clamp(box.hi, -largest, largest)});
    }
    return boxes;
}

// Which shapes a structure needs to hold: all but those without bounds to hit (NaN somewhere, or nothing inside).
inline std::vector<Id> can_be_hit(std::span<const Box<float>> boxes) {
    std::vector<Id> order;
    order.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (holds_any(boxes[i]))
            order.push_back(static_cast<Id>(i));
    return order;
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template std::vector<Box<float>> float_boxes(std::span<const Triangle<>>);
extern template void try_slot(Sheared<Ray<double>> &, const ShapeList<Triangle<>> &, Id, Hit<double> &);
extern template bool is_hit(const Sheared<Ray<double>> &, const ShapeList<Triangle<>> &, Id);
#endif

} // namespace course
