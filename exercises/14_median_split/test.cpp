// Grades exercise 14: where does a BVH split its primitives?
#include "exercises/14_median_split/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <set>

namespace course {

namespace {

// Boxes in a block of these edges; their sizes differ by a lot, so that lo does not stand for the middle.
std::vector<BuildItem> some_items(Random &random, std::size_t count, const Vec<double> &block, double largest = 0.3) {
    std::vector<BuildItem> items;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec<double> middle = block * Vec<double>(random.uniform(), random.uniform(), random.uniform());
        const Vec<double> half = largest * block * Vec<double>(random.uniform(), random.uniform(), random.uniform());
        items.push_back({{Vec<float>(middle - half), Vec<float>(middle + half)}, static_cast<int>(i)});
    }
    return items;
}

int longest_axis(const std::vector<BuildItem> &items) {
    Box<float> box{Vec<float>(infinity<float>), Vec<float>(-infinity<float>)};
    for (const BuildItem &item : items)
        box = {min(box.lo, item.box.lo), max(box.hi, item.box.hi)};
    const Vec<float> e = box.hi - box.lo;
    return e.x >= e.y ? (e.x >= e.z ? 0 : 2) : (e.y >= e.z ? 1 : 2);
}

float middle_of(const BuildItem &item, int axis) { return 0.5f * (item.box.lo[axis] + item.box.hi[axis]); }

// What must hold of any split by the median: nothing lost, half and half, and the halves in order along the axis.
void ask(Check &check, const Task &task, const std::vector<BuildItem> &before) {
    std::vector<BuildItem> items = before;
    const std::size_t first = task.split(items);
    const int axis = longest_axis(before);
    check.given({{"primitives", before.size()}, {"their longest axis", axis}});
    std::set<int> ids;
    for (const BuildItem &item : items) {
        ids.insert(item.id);
        check.that(item.box.lo == before[static_cast<std::size_t>(item.id)].box.lo, "each primitive keeps its box",
                   "number " + std::to_string(item.id) + " has another's");
    }
    check.same("how many primitives are there afterwards", ids.size(), before.size());
    check.same("how many go to the first child", first, before.size() / 2);
    float last = -infinity<float>, next = infinity<float>;
    for (std::size_t i = 0; i < items.size(); ++i) {
        float &border = i < first ? last : next;
        border = i < first ? std::max(border, middle_of(items[i], axis)) : std::min(border, middle_of(items[i], axis));
    }
    check.that(last <= next, "along the longest axis, no middle of the first child lies beyond one of the second",
               "one at " + std::to_string(last) + " is in the first, one at " + std::to_string(next) +
                   " in the second");
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "14_bvh", "The idea: cut the list"};
    };

    grading.check(
        question("half of them go to each child, ordered along the axis",
                 "The first half of the list, by the middles of the boxes, goes to the first child, the rest to "
                 "the second. That keeps the tree balanced: its depth is log2 n."),
        [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(1, i);
                ask(check, task, some_items(random, 2 + random.bits() % 60, {10, 1, 1}, 1e-5));
            }
        });

    grading.check(
        question("the axis is the longest one of the box around them all",
                 "A cut across the longest axis makes the two boxes compact. Taking the axes in turns, or always "
                 "x, leaves long slivers that many rays meet."),
        [&](Check &check) {
            for (unsigned i = 0; i < 150; ++i) {
                Random random(2, i);
                Vec<double> block{1, 1, 1};
                block[static_cast<int>(i % 3)] = 5;
                ask(check, task, some_items(random, 2 + random.bits() % 60, block, 1e-5));
            }
        });

    grading.check(
        question("a primitive counts where its middle is",
                 "Ordered by one of its ends, a large primitive goes to the wrong side and makes that child's box "
                 "larger than it need be."),
        [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(3, i);
                ask(check, task, some_items(random, 2 + random.bits() % 60, {10, 1, 1}));
            }
        });

    grading.check(
        question("primitives in the same place are split as well",
                 "Where all middles are equal no plane parts them; half of the list is still half of the list. A "
                 "split at a place in space leaves one child empty, and the builder runs for ever."),
        [&](Check &check) {
            Random random(4);
            std::vector<BuildItem> items = some_items(random, 40, {1, 0, 0}, 0.2);
            for (std::size_t i = 0; i < items.size(); ++i)
                if (i % 20)
                    items[i].box = items[0].box;
            ask(check, task, items);
            for (BuildItem &item : items)
                item.box = items[0].box;
            ask(check, task, items);
            for (std::size_t i = 0; i < items.size(); ++i) // one far away
                items[i].box = {Vec<float>(i ? 0.f : 1000.f), Vec<float>(i ? 1.f : 1001.f)};
            ask(check, task, items);
        });

    grading.check(
        question("the work grows with the number of primitives, not faster",
                 "A split needs the median, not the order of all: nth_element finds it in linear time, sorting "
                 "takes n log n, and in a builder it does so on every level."),
        [&](Check &check) {
            for (const std::size_t count : {std::size_t(1) << 10, std::size_t(1) << 16}) {
                Random random(5, count);
                std::vector<BuildItem> items = some_items(random, count, {9, 2, 3});
                check.given({{"primitives", count}});
                BuildItem::asked = 0;
                task.split(items);
                check.at_most("how often middle() is asked for", BuildItem::asked, 16 * count);
            }
        });
}

} // namespace course
