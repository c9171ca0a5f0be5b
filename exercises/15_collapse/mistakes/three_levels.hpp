// Mistake: three levels are taken away and no more, so a lopsided tree fills a few places only.
// Caught by: there are eight children, if there are eight leaves
#pragma once
#include "exercises/15_collapse/task.hpp"

namespace course::exercise {

inline std::vector<int> children_of_wide_node(const BinaryTree &tree, int node) {
    const auto at = [&](int number) { return tree.nodes[static_cast<std::size_t>(number)]; };
    std::vector<int> children{at(node).children[0], at(node).children[1]};
    for (int level = 1; level < 3; ++level) {
        std::vector<int> next;
        for (const int child : children)
            if (tree.is_leaf(child))
                next.push_back(child);
            else
                next.insert(next.end(), {at(child).children[0], at(child).children[1]});
        children = next;
    }
    return children;
}

inline constexpr Task task{children_of_wide_node};

} // namespace course::exercise
