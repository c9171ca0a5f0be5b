// Lesson 11, step 3: the octree, and the walk through it from near to far.
#pragma once
#include "chapters/10_uniform_grid/grid.hpp"
#include "chapters/11_octree/build.hpp"

namespace course {

template <Bounded S> struct Octree {
    using Shape = S;

    Box<float> box;
    Octants octants;
    ShapeList<Shape> shapes; // in the order in which the leaves name them first

    explicit Octree(std::span<const Shape> given, const OctreeRule &rule = {})
        : Octree(given, float_boxes(given), rule) {}
    std::size_t node_bytes() const {
        return octants.nodes.size() * sizeof(OctreeNode) + octants.entries.size() * sizeof(Id);
    }

  private:
    Octree(std::span<const Shape> given, const std::vector<Box<float>> &boxes, const OctreeRule &rule)
        : box(bounds(std::span<const Box<float>>(boxes))),
          octants(OctreeBuilder<Shape>(given, boxes, rule).build(can_be_hit(boxes), box)),
          shapes(given, number_by_appearance(octants.entries, given.size())) {}
};

// The ray as cubes see it. As in SlabRay, it stands for two rays a margin apart: planes are entered a little too early
// and left a little too late, so that a hit is never lost that rounding moved across a border. Cubes come turned round:
// on each axis, the half that the ray passes first is 0 and the other is 1.
class OctantRay {
  public:
    Vec<double> enter, step, late; // t where the ray enters the root cube, on each axis; t per edge; t per two margins
    unsigned turned;               // octant = turned octant ^ turned

    template <class T> OctantRay(const Ray<T> &ray, const Cube &cube) : turned(0) {
        const Vec<double> origin(ray.origin), direction(ray.direction), size = abs(direction), far = abs(origin);
        const Vec<double> reach = max(abs(cube.lo), abs(cube.lo + cube.edge));
        const double margin = (sizeof(T) == sizeof(float) ? 0x1p-20 : 0x1p-24) *
                              (std::max({far.x, far.y, far.z}) + std::max({reach.x, reach.y, reach.z}));
        const double least = 0x1p-30 * std::max({size.x, size.y, size.z}); // see SlabRay
        for (int axis = 0; axis < 3; ++axis) {
            const double inverse = 1 / std::max(size[axis], least);
            const bool backwards = std::signbit(direction[axis]);
            const double ahead = backwards ? origin[axis] - (cube.lo[axis] + cube.edge) : cube.lo[axis] - origin[axis];
            turned |= backwards ? 1u << axis : 0;
            enter[axis] = (ahead - margin) * inverse;
            step[axis] = cube.edge * inverse;
            late[axis] = 2 * margin * inverse;
        }
    }
};

// Calls offer(slot) for every entry of every leaf that the ray passes, near leaves first, until offer returns true or
// what is left begins beyond t_max.
//
// A cell's planes are those of its parent or halfway between, so no distance is ever computed anew: half a step is
// added or not. An octant's number, turned round, grows along the ray, since a ray changes from the first half of an
// axis to the second and never back: the order of numbers is an order from near to far.
template <class R, class Shape, class Offer> void walk(R &ray, const Octree<Shape> &tree, Offer &&offer) {
    struct Cell {
        Vec<double> enter; // on each axis
        double first;      // on all: where the ray is in the cell
        std::uint32_t node;
        int depth;
    };
    if (tree.octants.nodes.empty())
        return;
    const OctantRay octants(ray, tree.octants.cube);
    const double t_min = static_cast<double>(ray.t_min);
    Cell waiting[7 * 32 + 1]; // at most seven for each level and the next to look at
    int count = 0;
    waiting[count++] = {octants.enter, t_min, 0, 0};
    while (count > 0) {
        const Cell cell = waiting[--count];
        if (cell.first > static_cast<double>(ray.t_max))
            continue;
        ray.counts().node();
        const OctreeNode node = tree.octants.nodes[cell.node];
        if (node.is_leaf()) {
            for (std::uint32_t i = node.first(); i < node.first() + node.count(); ++i)
                if (offer(tree.octants.entries[i]))
                    return;
            continue;
        }
        const Vec<double> half = std::ldexp(0.5, -cell.depth) * octants.step;
        const Vec<double> middle = cell.enter + half;
        const double t_max = static_cast<double>(ray.t_max);
        for (unsigned turned = 8; turned-- > 0;) { // the farthest first, since the last to come is the next to go
            const unsigned octant = turned ^ octants.turned;
            if (!(node.octants() >> octant & 1))
                continue;
            const Vec<double> enter((turned & 1 ? middle : cell.enter).x, (turned & 2 ? middle : cell.enter).y,
                                    (turned & 4 ? middle : cell.enter).z);
            const Vec<double> leave = enter + half + octants.late;
            const double first = std::max({t_min, enter.x, enter.y, enter.z});
            if (!(first > std::min({t_max, leave.x, leave.y, leave.z})))
                waiting[count++] = {enter, first, node.child(octant), cell.depth + 1};
        }
    }
}

// A shape may lie in many leaves; chapter 10's short memory spares most of the repeated tests.
template <class R, class Shape, class Test> void traverse(R &ray, const Octree<Shape> &tree, Test &&test) {
    RecentSlots recent;
    walk(ray, tree, [&](Id slot) { return recent.is_new(slot) && test(slot); });
}

} // namespace course
