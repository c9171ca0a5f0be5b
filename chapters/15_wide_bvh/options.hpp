// Lesson 15: every step of the lesson can be left out, so that each can be measured on its own.
#pragma once

namespace course {

struct WideOptions {
    enum class Collapse { greedy, optimal } collapse = Collapse::optimal;
    enum class Leaf { one_by_one, eight, compact } leaf = Leaf::eight; // triangles at once, each corner kept once
    enum class Order { distance, octant } order = Order::octant;
    bool two_nodes = true;     // at a time, if the next two that wait are nodes
    bool one_hit_path = false; // a node with one child hit is left without the stack, at the price of a guess
    bool any_hit_loop = true;  // shadow rays have a walk of their own
    bool quick_t = true;       // a t that is clear is not confirmed again

    // The bounds of the lesson, as multiples of what was derived: with less, hits are lost or differ, and a test shows
    // it.
    float slab_pad = 1, edge_bound = 1, depth_bound = 1, clear_bound = 1;
};

} // namespace course
