// Lesson 09, step 5: the primitives of a structure, in an order of the structure's own, under the ids of the scene.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace course {

// A structure speaks of its shapes by slot: 0, 1, 2 ... in the order in which they lie in memory. Callers speak of
// primitives by id: their place among all primitives of the shapes in the order given, whatever the structure did with
// them. This list knows both. Tables are kept only where slot and id differ.
template <class Shape> class ShapeList {
  public:
    // In the order given.
    explicit ShapeList(std::span<const Shape> shapes) : shapes_(shapes.begin(), shapes.end()) {
        number(shapes);
        ids_ = first_ids_;
    }

    // Slot i holds shapes[order[i]]. Shapes that the order leaves out keep their ids and are in no slot.
    ShapeList(std::span<const Shape> shapes, std::span<const Id> order) {
        number(shapes);
        slots_.assign(shapes.size(), no_id);
        shapes_.reserve(order.size());
        ids_.reserve(order.size());
        for (const Id index : order) {
            slots_[index] = static_cast<Id>(shapes_.size());
            ids_.push_back(first_ids_.empty() ? index : first_ids_[index]);
            shapes_.push_back(shapes[index]);
        }
    }

    Id slots() const { return static_cast<Id>(shapes_.size()); }
    Id primitives() const { return primitives_; }
    const Shape &operator[](Id slot) const { return shapes_[slot]; }

    // The id of the shape's first primitive.
    Id first_id(Id slot) const { return ids_.empty() ? slot : ids_[slot]; }

    // Which shape holds the primitive `id`, and which of its primitives that is.
    struct Place {
        Id slot, local_id;
    };
    Place find(Id id) const {
        Id index = id, local = 0;
        if (!first_ids_.empty()) { // the last shape that does not begin after id
            const auto after = std::ranges::upper_bound(first_ids_, id);
            index = static_cast<Id>(after - first_ids_.begin()) - 1;
            local = id - first_ids_[index];
        }
        return {slots_.empty() ? index : slots_[index], local};
    }

    // Without what the shapes themselves may point to.
    std::size_t bytes() const {
        return shapes_.size() * sizeof(Shape) + (ids_.size() + slots_.size() + first_ids_.size()) * sizeof(Id);
    }

  private:
    void number(std::span<const Shape> shapes) {
        std::size_t total = 0;
        bool one_each = true;
        for (const Shape &shape : shapes) {
            one_each = one_each && size(shape) == 1;
            total += size(shape);
        }
        if (total >= no_id)
            throw std::length_error("more primitives than ids");
        primitives_ = static_cast<Id>(total);
        if (one_each)
            return;
        Id next = 0;
        for (const Shape &shape : shapes) {
            first_ids_.push_back(next);
            next += size(shape);
        }
    }

    std::vector<Shape> shapes_; // by slot
    std::vector<Id> ids_;       // by slot: the id of the first primitive; empty where that is the slot
    std::vector<Id> slots_;     // by place in the order given; empty where that is the slot
    std::vector<Id> first_ids_; // by place in the order given; empty where every shape holds one primitive
    Id primitives_ = 0;
};

} // namespace course
