// Mistake: the search ends when the largest child is a leaf, though others could be opened.
// Caught by: there are eight children, if there are eight leaves
#pragma once
#include "exercises/15_collapse/task.hpp"

namespace course::exercise {

inline std::vector<int> children_of_wide_node(const BinaryTree &tree, int node) {
    const auto at = [&](int number) { return tree.nodes[static_cast<std::size_t>(number)]; };
    std::vector<int> children{at(node).children[0], at(node).children[1]};
    while (children.size() < 8) {
        int largest = -1;
        for (int i = 0; i < static_cast<int>(children.size()); ++i) {
            const int child = children[static_cast<std::size_t>(i)];
            if ((largest < 0 || at(child).area > at(children[static_cast<std::size_t>(largest)]).area))
                largest = i;
        }
        if (tree.is_leaf(children[static_cast<std::size_t>(largest)]))
            return children;
        const BinaryTree::Node opened = at(children[static_cast<std::size_t>(largest)]);
        children[static_cast<std::size_t>(largest)] = opened.children[0];
        children.push_back(opened.children[1]);
    }
    return children;
}

inline constexpr Task task{children_of_wide_node};

} // namespace course::exercise
