// Exercise 14, solved: the nearest hit in a BVH, with as little work as possible.
#pragma once
#include "exercises/14_ordered_walk/task.hpp"

namespace course::exercise {

inline Hit<double> nearest(const Ray<double> &ray, const WalkTree &tree) {
    Hit<double> best;
    Ray<double> search = ray;
    struct Waiting {
        int node;
        double enter;
    };
    std::vector<Waiting> waiting;
    if (const auto enter = tree.enters(search, 0))
        waiting.push_back({0, *enter});
    while (!waiting.empty()) {
        const Waiting next = waiting.back();
        waiting.pop_back();
        if (next.enter > search.t_max) // a hit before it has been found since
            continue;
        if (tree.is_leaf(next.node)) {
            if (const auto t = tree.hit(search, next.node)) {
                best = {*t, tree.nodes[static_cast<std::size_t>(next.node)].sphere};
                search.t_max = *t;
            }
            continue;
        }
        const auto &children = tree.nodes[static_cast<std::size_t>(next.node)].children;
        const auto first = tree.enters(search, children[0]), second = tree.enters(search, children[1]);
        const bool second_is_nearer = first && second && *second < *first;
        if (second && !second_is_nearer)
            waiting.push_back({children[1], *second});
        if (first)
            waiting.push_back({children[0], *first});
        if (second_is_nearer)
            waiting.push_back({children[1], *second});
    }
    return best;
}

inline constexpr Task task{nearest};

} // namespace course::exercise
