// Lesson 12, step 5: the kd-tree, and the walk that goes to the near side of each plane first.
#pragma once
#include "chapters/09_aabb/slab.hpp"
#include "chapters/09_aabb/structure.hpp"
#include "chapters/10_uniform_grid/grid.hpp"
#include "chapters/12_kd_tree/build.hpp"
#include "chapters/12_kd_tree/least_cost.hpp"

namespace course {

// Rule says where the builder cuts; see the three names below.
template <Bounded S, class Rule> struct KdTreeBy {
    using Shape = S;

    std::vector<KdNode> nodes;
    std::vector<Id> lists;   // slots
    ShapeList<Shape> shapes; // in the order in which the leaves name them first
    Box<float> box;

    explicit KdTreeBy(std::span<const Shape> given, const Rule &rule = {})
        : KdTreeBy(given, float_boxes(given), rule) {}
    std::size_t node_bytes() const { return nodes.size() * sizeof(KdNode) + lists.size() * sizeof(Id); }

  private:
    KdTreeBy(std::span<const Shape> given, const std::vector<Box<float>> &boxes, const Rule &rule)
        : KdTreeBy(given, KdBuilder<Shape, Rule>(given, boxes, can_be_hit(boxes), rule)) {}

    KdTreeBy(std::span<const Shape> given, KdBuilder<Shape, Rule> built)
        : nodes(std::move(built.nodes)), lists(std::move(built.lists)), shapes(given, to_slots(given.size())),
          box(built.box) {}

    // Renames the shapes in the lists: the first to be named becomes slot 0, and so on. Returns who has which slot.
    std::vector<Id> to_slots(std::size_t count) {
        std::vector<Id> slots(count, no_id), order;
        for (Id &entry : lists) {
            Id &slot = slots[entry];
            if (slot == no_id) {
                slot = static_cast<Id>(order.size());
                order.push_back(entry);
            }
            entry = slot;
        }
        return order;
    }
};

template <class Shape> using KdTreeMiddle = KdTreeBy<Shape, MiddleOfCell>;
template <class Shape> using KdTreeMedian = KdTreeBy<Shape, MedianOfObjects>;
template <class Shape> using KdTreeSah = KdTreeBy<Shape, LeastCost>;

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
            const double d = std::copysign(std::max(size[axis], least), direction[axis]);
            axes_[axis] = {1 / d, (-origin[axis] + std::copysign(margin, d)) / d,
                           (-origin[axis] - std::copysign(margin, d)) / d, std::signbit(d)};
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

  private:
    struct Axis {
        double inverse, later, sooner;
        bool backwards;
    };
    Axis axes_[3];
};

// A cell is known by the part of the ray in it, from `enter` to `exit`. Of the two sides of a plane the ray needs the
// near one, the far one, or both: then the far one waits. Those that wait are looked at to the last, since around a
// plane a later one may begin a margin before an earlier one.
template <class R, class Shape, class Rule, class Test>
void traverse(R &ray, const KdTreeBy<Shape, Rule> &tree, Test &&test) {
    struct Visit {
        std::uint32_t node;
        double enter, exit;
    };
    const Span whole = SlabRay(ray, tree.box)(tree.box, static_cast<double>(ray.t_max));
    if (tree.shapes.slots() == 0 || whole.enter > whole.exit)
        return;
    const SplitRay split_ray(ray, tree.box);
    Visit stack[deepest_kd_leaf], here{0, whole.enter, whole.exit};
    int waiting = 0;
    RecentSlots recent;
    while (true) {
        ray.counts().node();
        const KdNode node = tree.nodes[here.node];
        if (!node.is_leaf()) {
            const auto [near_ends, far_begins, from_above] = split_ray(node.axis(), static_cast<double>(node.at()));
            const std::uint32_t lower = here.node + 1, upper = node.upper();
            const std::uint32_t near = from_above ? upper : lower, far = from_above ? lower : upper;
            if (far_begins > here.exit)
                here.node = near;
            else if (near_ends < here.enter)
                here.node = far;
            else {
                stack[waiting++] = {far, std::max(here.enter, far_begins), here.exit};
                here = {near, here.enter, std::min(here.exit, near_ends)};
            }
            continue;
        }
        for (std::uint32_t i = node.first(); i < node.first() + node.count(); ++i)
            if (const Id slot = tree.lists[i]; recent.is_new(slot) && test(slot))
                return;
        do {
            if (waiting == 0)
                return;
            here = stack[--waiting];
        } while (here.enter > static_cast<double>(ray.t_max));
    }
}

} // namespace course
