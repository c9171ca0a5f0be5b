// Lesson 13, step 5: the BSP-tree, and the walk through it: two intervals of one ray.
#pragma once
#include "chapters/11_octree/octree.hpp"
#include "chapters/13_bsp_tree/build.hpp"

namespace course {

template <Bounded S> struct Bsp {
    using Shape = S;

    Box<float> box;
    BspPlanes planes;
    ShapeList<Shape> shapes; // in the order in which the leaves name them first

    explicit Bsp(std::span<const Shape> given, const BspRule &rule = {})
        : Bsp(given, float_boxes(given), as_deep_as_a_walk(rule)) {}
    std::size_t node_bytes() const {
        return planes.nodes.size() * sizeof(BspNode) + planes.entries.size() * sizeof(Id);
    }

  private:
    static BspRule as_deep_as_a_walk(BspRule rule) {
        rule.deepest = std::min(rule.deepest, deepest_bsp);
        return rule;
    }
    Bsp(std::span<const Shape> given, const std::vector<Box<float>> &boxes, const BspRule &rule)
        : box(bounds(std::span<const Box<float>>(boxes))),
          planes(BspBuilder<Shape>(given, rule).build(boxes, can_be_hit(boxes), box)),
          shapes(given, number_by_appearance(planes.entries, given.size())) {}
};

// The ray as planes see it. Along the ray the height over a plane is height + t speed.
class PlaneRay {
  public:
    template <class T, class S> PlaneRay(const Ray<T> &ray, const Box<S> &reach)
        : origin_(ray.origin), direction_(ray.direction) {
        const Vec<double> far = abs(origin_), size = abs(direction_);
        // As in SlabRay. A normal's length is hardly more than 1, so a point moved by the margin on every axis changes
        // its height by less than twice the margin.
        margin_ = 2 * (sizeof(T) == sizeof(float) ? 0x1p-20 : 0x1p-24) *
                  (std::max({far.x, far.y, far.z}) + largest_coordinate(reach));
        least_ = 0x1p-60 * std::max({size.x, size.y, size.z});
    }

    // Until when the ray may be on the side where it comes from, and from when on the other: the two overlap by the
    // margin. Parallel to the plane, or nearly so, they are far apart on one side or overlap everywhere.
    struct Crossing {
        bool starts_behind;
        double leave, enter;
    };
    Crossing over(const SplitPlane &plane) const {
        const double height = plane.height(origin_), speed = dot(Vec<double>(plane.normal), direction_);
        const double inverse = 1 / std::max(std::abs(speed), least_);
        const bool rises = !std::signbit(speed);
        const double ahead = rises ? -height : height; // to the plane
        return {rises, (ahead + margin_) * inverse, (ahead - margin_) * inverse};
    }

  private:
    Vec<double> origin_, direction_;
    double margin_, least_;
};

// At each plane the ray's interval is cut in two. The side where the ray comes from is first; the other waits. No
// interval is ever longer than its parent's, and each plane is met by the ray itself, so errors do not add up.
template <class R, class Shape, class Test> void traverse(R &ray, const Bsp<Shape> &tree, Test &&test) {
    struct Cell {
        std::uint32_t node;
        double enter, leave;
    };
    if (tree.planes.nodes.empty())
        return;
    const Span span = SlabRay(ray, tree.box)(tree.box, static_cast<double>(ray.t_max));
    if (span.enter > span.exit)
        return;
    const PlaneRay plane_ray(ray, tree.box);
    RecentSlots recent;
    Cell waiting[deepest_bsp + 1];
    int count = 0;
    waiting[count++] = {0, span.enter, span.exit};
    while (count > 0) {
        Cell cell = waiting[--count];
        cell.leave = std::min(cell.leave, static_cast<double>(ray.t_max));
        if (cell.enter > cell.leave)
            continue;
        while (true) {
            ray.counts().node();
            const BspNode &node = tree.planes.nodes[cell.node];
            if (node.is_leaf())
                break;
            const auto [starts_behind, leave, enter] = plane_ray.over(node.plane());
            const std::uint32_t first = starts_behind ? cell.node + 1 : node.front();
            const std::uint32_t second = starts_behind ? node.front() : cell.node + 1;
            const bool meets_first = !(leave < cell.enter), meets_second = !(enter > cell.leave);
            if (meets_first && meets_second)
                waiting[count++] = {second, std::max(cell.enter, enter), cell.leave};
            cell = meets_first ? Cell{first, cell.enter, std::min(cell.leave, leave)}
                               : Cell{second, std::max(cell.enter, enter), cell.leave};
        }
        const BspNode &leaf = tree.planes.nodes[cell.node];
        for (std::uint32_t i = leaf.first(); i < leaf.end(); ++i)
            if (const Id slot = tree.planes.entries[i]; recent.is_new(slot) && test(slot))
                return;
    }
}

} // namespace course
