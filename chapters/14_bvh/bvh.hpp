// Lesson 14, step 5: the bounding volume hierarchy, and the walk through it that goes to near boxes first.
#pragma once
#include "chapters/09_aabb/structure.hpp"
#include "chapters/14_bvh/build.hpp"

namespace course {

// Rule says where the builder cuts; see Bvh and MedianBvh below.
template <Bounded S, class Rule> struct BvhBy {
    using Shape = S;

    Tree tree;
    ShapeList<Shape> shapes; // in the order of the leaves
    Box<float> box;

    explicit BvhBy(std::span<const Shape> given, const Rule &rule = {}) : BvhBy(given, float_boxes(given), rule) {}
    std::size_t node_bytes() const { return tree.nodes.size() * sizeof(Node); }

  private:
    BvhBy(std::span<const Shape> given, std::span<const Box<float>> boxes, const Rule &rule)
        : tree(TreeBuilder<Rule>(boxes, can_be_hit(boxes), rule).build()), shapes(given, tree.order), box(tree.box) {
        tree.order = {};
    }
};

template <class Shape> using Bvh = BvhBy<Shape, BinnedSah>;
template <class Shape> using MedianBvh = BvhBy<Shape, LongestAxisMedian>;

// Asks the memory for what will be looked at later.
template <class Shape, class Rule> void prefetch(const BvhBy<Shape, Rule> &bvh, Link link) {
    if (link.is_leaf())
        __builtin_prefetch(&bvh.shapes[link.first]);
    else
        __builtin_prefetch(&bvh.tree.nodes[link.first]);
}

// Of two children that the ray enters, the nearer comes first; the other waits with the t at which it is entered, and
// is dropped if a hit before it has been found by then.
template <class R, class Shape, class Rule, class Test>
void traverse(R &ray, const BvhBy<Shape, Rule> &bvh, Test &&test) {
    Link links[deepest]; // the children that wait, and when the ray enters them
    float enters[deepest];
    int waiting = 0;

    const NodeRay node_ray(ray, bvh.box);
    float t_max = node_ray.scaled(static_cast<double>(ray.t_max));
    Four limit = node_ray.limit(t_max);
    Link at = bvh.tree.root;
    if (bvh.shapes.slots() == 0)
        return;
    while (true) {
        if (!at.is_leaf()) {
            ray.counts().node();
            const Node &node = bvh.tree.nodes[at.first];
            const auto entries = node_ray(node, limit);
            if (entries.meets[0] && entries.meets[1]) {
                if (entries.enter[1] < entries.enter[0]) {
                    links[waiting] = node.children[0];
                    enters[waiting] = entries.enter[0];
                    at = node.children[1];
                } else {
                    links[waiting] = node.children[1];
                    enters[waiting] = entries.enter[1];
                    at = node.children[0];
                }
                prefetch(bvh, links[waiting++]);
                continue;
            }
            if (entries.meets[0]) {
                at = node.children[0];
                continue;
            }
            if (entries.meets[1]) {
                at = node.children[1];
                continue;
            }
        } else {
            for (Id slot = at.first; slot < at.first + at.count; ++slot)
                if (test(slot))
                    return;
            t_max = node_ray.scaled(static_cast<double>(ray.t_max));
            limit = node_ray.limit(t_max);
        }

        // Nothing further below: on to what waits, but for what begins beyond the best hit.
        do {
            if (waiting == 0)
                return;
            --waiting;
        } while (enters[waiting] > t_max);
        at = links[waiting];
    }
}

} // namespace course
