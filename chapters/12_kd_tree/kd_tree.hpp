// Lesson 12, step 6: the kd-tree, and the walk that goes to the near side of each plane first.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/10_uniform_grid/grid.hpp"
#include "chapters/12_kd_tree/build.hpp"
#include "chapters/12_kd_tree/least_cost.hpp"
#include "chapters/12_kd_tree/split_ray.hpp"

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

// A cell is known by the part of the ray in it, from `enter` to `exit`. A box shortens it, maybe to nothing. Of the two
// sides of a plane the ray needs the near one, the far one, or both: then the far one waits. Those that wait are looked
// at to the last, since around a plane a later one may begin a margin before an earlier one.
template <class R, class Shape, class Rule, class Test>
void traverse(R &ray, const KdTreeBy<Shape, Rule> &tree, Test &&test) {
    struct Visit {
        std::uint32_t node;
        double enter, exit;
    };
    if (tree.shapes.slots() == 0)
        return;
    const SplitRay split_ray(ray, tree.box);
    Visit stack[deepest_kd_leaf], here{0, static_cast<double>(ray.t_min), static_cast<double>(ray.t_max)};
    int waiting = 0;
    RecentSlots recent;
    while (true) {
        ray.counts().node();
        const KdNode *const node = &tree.nodes[here.node];
        if (node->is_cut()) {
            const auto [near_ends, far_begins, from_above] = split_ray(node->axis(), static_cast<double>(node->at()));
            const std::uint32_t lower = here.node + 1, upper = node->upper();
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
        if (node->is_box()) {
            const Span span = split_ray.within(node + 1, {here.enter, here.exit});
            here = {here.node + KdNode::box_size, span.enter, span.exit};
            if (!(here.enter > here.exit))
                continue;
        } else
            for (std::uint32_t i = node->first(); i < node->first() + node->count(); ++i)
                if (const Id slot = tree.lists[i]; recent.is_new(slot) && test(slot))
                    return;
        do {
            if (waiting == 0)
                return;
            here = stack[--waiting];
        } while (here.enter > static_cast<double>(ray.t_max));
    }
}

#ifdef COURSE_COMPILED_ONCE // for all programs, in compiled_once.cpp
extern template class KdBuilder<Triangle<>, MiddleOfCell>;
extern template class KdBuilder<Triangle<>, MedianOfObjects>;
extern template class KdBuilder<Triangle<>, LeastCost>;
#endif

} // namespace course
