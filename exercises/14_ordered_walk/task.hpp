// Exercise 14, the second: what an answer hands over.
#pragma once
#include "chapters/01_ray_casting/hit.hpp"
#include "chapters/02_primitives/box.hpp"
#include "exercises/grading/not_done.hpp"

#include <optional>
#include <vector>

namespace course {

// A tree as small as can be: node 0 is the root. An inner node has two children, a leaf a single sphere.
struct WalkTree {
    struct Node {
        Box<float> box;
        int children[2]; // numbers of nodes; in a leaf, both are -1
        Id sphere;       // of a leaf
    };
    std::vector<Node> nodes;
    std::vector<Sphere<float>> spheres;

    // When the ray enters the node's box, at t_min at the earliest; nothing where it misses the box or enters it beyond
    // its t_max. Counts the nodes that are asked.
    std::optional<double> enters(const Ray<double> &ray, int node) const {
        ++boxes_asked;
        const Span span = span_within(ray, nodes[static_cast<std::size_t>(node)].box);
        const double enter = std::max(span.enter, ray.t_min);
        if (!(enter <= std::min(span.exit, ray.t_max)))
            return {};
        return enter;
    }
    // The test of a leaf's sphere. Counts the tests.
    std::optional<double> hit(const Ray<double> &ray, int leaf) const {
        ++spheres_tested;
        return intersect(ray, spheres[nodes[static_cast<std::size_t>(leaf)].sphere]);
    }
    bool is_leaf(int node) const { return nodes[static_cast<std::size_t>(node)].children[0] < 0; }

    mutable std::size_t boxes_asked = 0, spheres_tested = 0;
};

struct Task {
    Hit<double> (*nearest)(const Ray<double> &, const WalkTree &);
};

} // namespace course
