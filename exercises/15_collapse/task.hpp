// Exercise 15: what an answer hands over.
#pragma once
#include "exercises/grading/not_done.hpp"

#include <vector>

namespace course {

// A binary tree as its builder leaves it: node 0 is the root.
struct BinaryTree {
    struct Node {
        double area;     // of the surface of its box; never larger than its parent's
        int children[2]; // numbers of nodes; in a leaf, both are -1
    };
    std::vector<Node> nodes;

    bool is_leaf(int node) const { return nodes[static_cast<std::size_t>(node)].children[0] < 0; }
};

struct Task {
    std::vector<int> (*children_of_wide_node)(const BinaryTree &, int);
};

} // namespace course
