// Grades exercise 15: which nodes of a binary tree become the eight children of a wide node?
#include "exercises/15_collapse/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace course {

namespace {

// A tree with so many leaves, cut at random; `lopsided` 1 makes each cut take off a single leaf.
int grow(BinaryTree &tree, Random &random, int leaves, double area, double lopsided) {
    const std::size_t number = tree.nodes.size();
    tree.nodes.push_back({area, {-1, -1}});
    if (leaves > 1) {
        const int first = std::max(1, static_cast<int>(random.uniform(0, 1 - lopsided) * leaves));
        const int a = grow(tree, random, first, area * random.uniform(0.3, 0.95), lopsided);
        const int b = grow(tree, random, leaves - first, area * random.uniform(0.3, 0.95), lopsided);
        tree.nodes[number].children[0] = a;
        tree.nodes[number].children[1] = b;
    }
    return static_cast<int>(number);
}

std::set<int> leaves_under(const BinaryTree &tree, int node) {
    if (tree.is_leaf(node))
        return {node};
    std::set<int> all = leaves_under(tree, tree.nodes[static_cast<std::size_t>(node)].children[0]);
    all.merge(leaves_under(tree, tree.nodes[static_cast<std::size_t>(node)].children[1]));
    return all;
}

// The inner nodes that were opened to come from the root to the chosen ones, the root apart.
void opened_above(const BinaryTree &tree, int node, const std::set<int> &chosen, std::vector<int> &opened, bool root) {
    if (chosen.contains(node) || tree.is_leaf(node))
        return;
    if (!root)
        opened.push_back(node);
    for (const int child : tree.nodes[static_cast<std::size_t>(node)].children)
        opened_above(tree, child, chosen, opened, false);
}

std::string text(const std::vector<int> &nodes) {
    std::string all;
    for (const int node : nodes)
        all += (all.empty() ? "" : ", ") + std::to_string(node);
    return all.empty() ? "none" : all;
}

std::vector<int> answer(Check &check, const Task &task, const BinaryTree &tree, int root) {
    const auto yours = task.children_of_wide_node(tree, root);
    check.given({{"node", root}, {"leaves under it", leaves_under(tree, root).size()}, {"your children", text(yours)}});
    for (const int node : yours)
        check.that(node >= 0 && static_cast<std::size_t>(node) < tree.nodes.size(), "numbers of nodes",
                   std::to_string(node));
    return yours;
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "15_wide_bvh", "From two children to eight"};
    };

    grading.check(
        question("every leaf lies under exactly one child",
                 "A child stands for all that is under it. Opening a child takes it out of the list and puts its two "
                 "children in its place: nothing is lost and nothing is there twice."),
        [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(1, i);
                BinaryTree tree;
                const int root = grow(tree, random, 2 + static_cast<int>(random.bits() % 60), 1, 0);
                std::size_t sum = 0;
                std::set<int> all;
                for (const int node : answer(check, task, tree, root)) {
                    check.that(node != root, "the children of the node", "the node itself");
                    const auto under = leaves_under(tree, node);
                    sum += under.size();
                    all.insert(under.begin(), under.end());
                }
                check.same("how many leaves are under the children", all.size(), leaves_under(tree, root).size());
                check.same("how many, each child counted by itself", sum, all.size());
            }
        });

    grading.check(
        question("there are eight children, if there are eight leaves",
                 "A wide node asks eight boxes in the time of one, so empty places are work for nothing. Open until "
                 "there are eight, or nothing but leaves; also where the tree is lopsided."),
        [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(2, i);
                BinaryTree tree;
                const int leaves = 2 + static_cast<int>(random.bits() % 30);
                const int root = grow(tree, random, leaves, 1, i % 3 * 0.5);
                check.same("how many children", answer(check, task, tree, root).size(),
                           static_cast<std::size_t>(std::min(leaves, 8)));
            }
        });

    grading.check(
        question("the largest child is opened first",
                 "A ray meets a box as often as its surface is large. A large child that stays closed is met often, "
                 "and what is under it costs another node each time; a small one seldom is."),
        [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(3, i);
                BinaryTree tree;
                const int root = grow(tree, random, 9 + static_cast<int>(random.bits() % 60), 1, 0);
                const auto yours = answer(check, task, tree, root);
                std::vector<int> opened;
                opened_above(tree, root, {yours.begin(), yours.end()}, opened, true);
                const auto area = [&](int node) { return tree.nodes[static_cast<std::size_t>(node)].area; };
                double largest_left = 0;
                for (const int node : yours)
                    largest_left = std::max(largest_left, tree.is_leaf(node) ? 0 : area(node));
                for (const int node : opened)
                    check.that(area(node) >= largest_left, "no opened node smaller than one that stayed closed",
                               "node " + std::to_string(node) + " of area " + std::to_string(area(node)) +
                                   " was opened, one of " + std::to_string(largest_left) + " was not");
            }
        });

    grading.check(
        question("any node can be collapsed, not only the root", "The builder goes on with each of the eight in turn."),
        [&](Check &check) {
            Random random(4);
            BinaryTree tree;
            grow(tree, random, 300, 1, 0);
            for (int node = 0; node < static_cast<int>(tree.nodes.size()); ++node)
                if (!tree.is_leaf(node)) {
                    std::set<int> all;
                    for (const int child : answer(check, task, tree, node))
                        all.merge(leaves_under(tree, child));
                    check.that(all == leaves_under(tree, node), "the leaves under this node", "others");
                }
        });
}

} // namespace course
