// Grades exercise 14, the second: the nearest hit in a BVH, with as little work as possible.
#include "exercises/14_ordered_walk/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace course {

namespace {

// Splits the spheres with these numbers by the median of their middles, and adds the nodes.
int build(WalkTree &tree, std::span<Id> ids) {
    Box<float> box{Vec<float>(infinity<float>), Vec<float>(-infinity<float>)};
    for (const Id id : ids) {
        const Sphere<float> &s = tree.spheres[id];
        box = {min(box.lo, s.centre - 1.001f * s.radius), max(box.hi, s.centre + 1.001f * s.radius)};
    }
    const std::size_t number = tree.nodes.size();
    tree.nodes.push_back({box, {-1, -1}, ids[0]});
    if (ids.size() > 1) {
        const Vec<float> e = box.hi - box.lo;
        const int axis = e.x >= e.y ? (e.x >= e.z ? 0 : 2) : (e.y >= e.z ? 1 : 2);
        std::ranges::sort(ids, {}, [&](Id id) { return tree.spheres[id].centre[axis]; });
        const int first = build(tree, ids.first(ids.size() / 2)), second = build(tree, ids.subspan(ids.size() / 2));
        tree.nodes[number].children[0] = first;
        tree.nodes[number].children[1] = second;
    }
    return static_cast<int>(number);
}

// Spheres that fill a block of edge 2, so that behind the first hit there are many more.
WalkTree some_tree(std::size_t count, std::uint64_t seed) {
    WalkTree tree;
    const double radius = 1.2 / std::cbrt(static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        Random random(seed, i);
        tree.spheres.push_back({Vec<float>(any_point(random, 1)), static_cast<float>(radius * random.uniform(0.3, 1))});
    }
    std::vector<Id> ids(count);
    std::iota(ids.begin(), ids.end(), 0);
    build(tree, ids);
    return tree;
}

Ray<double> any_ray(Random &random) {
    const Vec<double> origin = 3. * normalize(any_point(random, 1));
    return {origin, any_point(random, 1) - origin};
}

Hit<double> by_asking_all(const Ray<double> &ray, const WalkTree &tree) {
    Hit<double> best;
    for (Id id = 0; id < tree.spheres.size(); ++id)
        if (const auto t = intersect(ray, tree.spheres[id]); t && *t < best.t)
            best = {*t, id};
    return best;
}

void ask(Check &check, const Task &task, const Ray<double> &ray, const WalkTree &tree) {
    const auto expected = by_asking_all(ray, tree);
    const auto yours = task.nearest(ray, tree);
    check.given({{"ray", ray}, {"t_max", ray.t_max}, {"spheres", tree.spheres.size()}});
    const auto text = [](const Hit<double> &hit) {
        return hit.id == no_id ? std::string("a miss")
                               : "sphere " + std::to_string(hit.id) + " at t = " + std::to_string(hit.t);
    };
    check.that(yours.id == expected.id && yours.t == expected.t, text(expected), text(yours));
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) { return Question{name, why, "14_bvh", "The walk"}; };

    grading.check(
        question("the nearest hit is found, the same as by asking every sphere",
                 "The boxes of two children may overlap, so a hit in one child says nothing about the other: it "
                 "may hold a nearer one. Only when its box begins beyond the hit is it out of the question."),
        [&](Check &check) {
            for (const std::size_t count : {1, 2, 3, 17, 400}) {
                const WalkTree tree = some_tree(count, count);
                for (unsigned i = 0; i < 150; ++i) {
                    Random random(1, i);
                    ask(check, task, any_ray(random), tree);
                }
            }
        });

    grading.check(question("nothing beyond t_max counts, and rays may begin inside",
                           "The ray's own interval is where the search begins; a hit narrows it further."),
                  [&](Check &check) {
                      const WalkTree tree = some_tree(100, 5);
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(2, i);
                          Ray<double> ray{any_point(random, 1), any_point(random, 1)};
                          ray.t_max = random.uniform(0.01, 2);
                          ask(check, task, ray, tree);
                      }
                  });

    grading.check(
        question("a box that begins beyond the nearest hit is not opened",
                 "Narrow t_max to each hit that you find, so that enters() says no to what lies behind it; and look "
                 "again when a node that waited comes to its turn, since a hit may have been found meanwhile."),
        [&](Check &check) {
            const WalkTree tree = some_tree(4096, 7);
            tree.spheres_tested = 0;
            for (unsigned i = 0; i < 200; ++i) {
                Random random(3, i);
                task.nearest(any_ray(random), tree);
            }
            check.given({{"spheres", 4096}, {"rays", 200}});
            check.at_most("how many spheres are tested in all", tree.spheres_tested, 1500);
        });

    grading.check(question("the nearer child is visited first",
                           "The sooner a near hit is found, the more of the tree lies behind it. Compare when the two "
                           "children's boxes are entered."),
                  [&](Check &check) {
                      const WalkTree tree = some_tree(4096, 7);
                      tree.boxes_asked = 0;
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(3, i);
                          task.nearest(any_ray(random), tree);
                      }
                      check.given({{"spheres", 4096}, {"rays", 200}});
                      check.at_most("how many boxes are asked in all", tree.boxes_asked, 10400);
                  });

    grading.check(
        question("the work grows much more slowly than the scene",
                 "Eight times as many spheres, twice as far down the tree and a little more: that is what the tree "
                 "is for."),
        [&](Check &check) {
            std::size_t asked[2];
            for (const int large : {0, 1}) {
                const WalkTree tree = some_tree(large ? 16384 : 512, 9);
                for (unsigned i = 0; i < 200; ++i) {
                    Random random(4, i);
                    task.nearest(any_ray(random), tree);
                }
                asked[large] = tree.boxes_asked;
            }
            check.given({{"spheres", 16384}, {"boxes asked with 512 spheres", asked[0]}});
            check.at_most("how many boxes are asked with 16,384", asked[1], 5 * asked[0]);
        });
}

} // namespace course
