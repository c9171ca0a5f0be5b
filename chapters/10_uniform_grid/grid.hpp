// Lesson 10, step 5: the uniform grid: build and walk.
#pragma once
#include "chapters/09_aabb/slab.hpp"
#include "chapters/09_aabb/structure.hpp"
#include "chapters/10_uniform_grid/cell_lists.hpp"
#include "chapters/10_uniform_grid/cell_walk.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace course {

// How many cells a grid has: so many for each shape (B §4 says 27), but not so many that its lists would grow beyond
// all measure, as they do where many shapes are large.
struct CellsPerShape {
    double cells = 27;
    double most_entries_per_shape = 64, most_entries = 0x1p25;

    Lattice operator()(const Box<float> &box, double shapes, const Footprint &sum) const {
        double wanted = cells * shapes;
        while (true) {
            const Lattice lattice(box, wanted);
            if (lattice.cells() <= 1 ||
                (lattice.expected_entries(shapes, sum) <= most_entries_per_shape * shapes + most_entries &&
                 lattice.cells() <= 0x1p+30))
                return lattice;
            wanted = 0.7 * std::min(wanted, lattice.cells());
        }
    }
};

// Calls mark(cell) for every cell that the shape may touch. Halving the cells in question, and asking of each half
// whether the shape reaches there at all, takes a number of questions in proportion to the cells that are marked.
template <class Shape, class Mark> void each_cell_of(const Overlap<Shape> &overlap, const Lattice &lattice,
                                                     const glm::ivec3 &first, const glm::ivec3 &last, Mark &&mark) {
    Box<double> box = lattice.box_of(first, last);
    box.lo -= lattice.margin;
    box.hi += lattice.margin;
    if (!overlap(box))
        return;
    const glm::ivec3 more = last - first;
    const int axis = more.x >= more.y ? (more.x >= more.z ? 0 : 2) : (more.y >= more.z ? 1 : 2);
    if (more[axis] == 0)
        return mark(first);
    glm::ivec3 end_of_low = last, begin_of_high = first;
    end_of_low[axis] = first[axis] + more[axis] / 2;
    begin_of_high[axis] = end_of_low[axis] + 1;
    each_cell_of(overlap, lattice, first, end_of_low, mark);
    each_cell_of(overlap, lattice, begin_of_high, last, mark);
}

template <Bounded S> struct Grid {
    using Shape = S;

    Box<float> box = empty_box();
    Lattice lattice;
    CellLists cells;
    ShapeList<Shape> shapes; // neighbours in space are neighbours in the list

    explicit Grid(std::span<const Shape> given, const CellsPerShape &rule = {})
        : Grid(given, float_boxes(given), rule) {}
    std::size_t node_bytes() const { return cells.bytes(); }

  private:
    Grid(std::span<const Shape> given, const std::vector<Box<float>> &boxes, const CellsPerShape &rule)
        : Grid(given, boxes, can_be_hit(boxes), rule) {}

    Grid(std::span<const Shape> given, const std::vector<Box<float>> &boxes, std::vector<Id> order,
         const CellsPerShape &rule);

    Lattice box_and_lattice(std::span<const Shape> given, const std::vector<Box<float>> &boxes,
                            const std::vector<Id> &order, const CellsPerShape &rule) {
        Footprint sum;
        for (const Id id : order) {
            box = merge(box, boxes[id]);
            sum += Overlap<Shape>(given[id]).footprint();
        }
        return rule(box, static_cast<double>(order.size()), sum);
    }

    // By the cell that holds the middle.
    const std::vector<Id> &sorted(const std::vector<Box<float>> &boxes, std::vector<Id> &order) const {
        std::vector<std::pair<std::uint32_t, Id>> keyed;
        for (const Id id : order)
            keyed.push_back({cells.number(lattice.cell_at(centre(boxes[id]))), id});
        std::ranges::sort(keyed);
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = keyed[i].second;
        return order;
    }
};

template <Bounded S> Grid<S>::Grid(std::span<const Shape> given, const std::vector<Box<float>> &boxes,
                                   std::vector<Id> order, const CellsPerShape &rule)
    : lattice(box_and_lattice(given, boxes, order, rule)), cells(lattice.count), shapes(given, sorted(boxes, order)) {
    std::vector<Entry> entries;
    for (Id slot = 0; slot < order.size(); ++slot) {
        const Box<float> &own = boxes[order[slot]];
        each_cell_of(Overlap<Shape>(shapes[slot]), lattice, lattice.cell_at(Vec<double>(own.lo) - lattice.margin),
                     lattice.cell_at(Vec<double>(own.hi) + lattice.margin), [&](const glm::ivec3 &cell) {
                         entries.push_back({cells.number(cell), slot});
                     });
    }
    cells.fill(entries);
}

// The last few shapes that a ray was tested against, so that a shape in several cells along the ray is seldom tested
// twice. (A mailbox for each shape would forget nothing, but each ray would need its own, as large as the scene.)
class RecentSlots {
  public:
    RecentSlots() { recent_.fill(no_id); }
    bool is_new(Id slot) { return std::exchange(recent_[slot % recent_.size()], slot) != slot; }

  private:
    std::array<Id, 16> recent_;
};

// A shape in this cell may be hit further on, behind something in the next cell: the walk ends where the next cell
// begins beyond the nearest hit, not with the first cell that has one.
template <class R, class Shape, class Test> void traverse(R &ray, const Grid<Shape> &grid, Test &&test) {
    const Box<double> whole = grid.lattice.box();
    const Span span = SlabRay(ray, whole)(whole, static_cast<double>(ray.t_max));
    if (grid.shapes.slots() == 0 || span.enter > span.exit)
        return;
    if (is_far(ray, grid.lattice)) {
        for (Id slot = 0; slot < grid.shapes.slots(); ++slot)
            if (test(slot))
                return;
        return;
    }
    RecentSlots recent;
    CellWalk walk(ray, grid.lattice, span.enter);
    do {
        ray.counts().node();
        for (const Id slot : grid.cells.in(walk.cell()))
            if (recent.is_new(slot) && test(slot))
                return;
    } while (walk.leaves() <= static_cast<double>(ray.t_max) && walk.step());
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template struct Grid<Triangle<>>;
#endif

} // namespace course
