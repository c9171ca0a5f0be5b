// Grades exercise 04: the bias of a shadow map that is just enough.
#include "exercises/04_depth_bias/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

namespace course {

namespace {

MapView any_view(Random &random, int texels) {
    const Vec<double> eye = any_point(random, 3), forward = any_direction(random);
    const Vec<double> right = normalize(cross(forward, any_direction(random)));
    return {eye, forward, right, cross(right, forward), random.uniform(0.3, 1), texels};
}

// A plane that the lamp sees at this depth in the middle, inclined so that the cosine to the line of sight there is
// this.
struct Plane {
    Vec<double> point, normal;
};

Plane any_plane(const MapView &view, Random &random, double depth, double cosine) {
    const double angle = random.uniform(0, 2 * pi), sine = std::sqrt(1 - cosine * cosine);
    const Vec<double> aside = std::cos(angle) * view.right + std::sin(angle) * view.up;
    return {view.eye + depth * view.forward, sine * aside - cosine * view.forward};
}

Vec<double> sight(const MapView &view, double x, double y) {
    const double h = view.half_width;
    return view.forward + (2 * x - 1) * h * view.right + (1 - 2 * y) * h * view.up;
}

// How deep the lamp sees the plane at a place of its picture.
double depth_at(const MapView &view, const Plane &plane, double x, double y) {
    return dot(plane.normal, plane.point - view.eye) / dot(plane.normal, sight(view, x, y));
}

// One texel on an inclined plane: a point in it, and how much deeper than the texel's middle its corners lie at most.
struct Case {
    MapView view;
    Plane plane;
    Vec<double> point;
    double depth, deeper, deepest;
};

Case any_case(Random &random) {
    const MapView view = any_view(random, 1024);
    const double cosine = random.uniform(0.35, 0.95), n = view.texels;
    const Plane plane = any_plane(view, random, random.uniform(2, 30), cosine);
    // Near the middle of the picture, so that the lamp sees the plane.
    const int i = static_cast<int>(random.uniform(0.4, 0.6) * n), j = static_cast<int>(random.uniform(0.4, 0.6) * n);
    const double x = (i + random.uniform(0.02, 0.98)) / n, y = (j + random.uniform(0.02, 0.98)) / n;
    const double middle = depth_at(view, plane, (i + 0.5) / n, (j + 0.5) / n), depth = depth_at(view, plane, x, y);
    double deepest = 0;
    for (const int corner : {0, 1, 2, 3})
        deepest = std::max(deepest, depth_at(view, plane, (i + corner % 2) / n, (j + corner / 2) / n) - middle);
    return {view, plane, view.eye + depth * sight(view, x, y), depth, depth - middle, deepest};
}

void show(Check &check, const Case &it) {
    check.given({{"point", it.point},
                 {"normal", it.plane.normal},
                 {"eye", it.view.eye},
                 {"forward", it.view.forward},
                 {"right", it.view.right},
                 {"half width", it.view.half_width},
                 {"texels", it.view.texels},
                 {"depth", it.depth}});
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("04_shadow_map");
    const char *const lesson = "The bias that is just enough";

    grading.check(
        "no place of a surface shadows itself",
        "The map knows the depth of its texel's middle. Half a texel to the side and half a texel up, an inclined "
        "surface is deeper by half a texel's width times its two slopes, added without their signs. A texel is 2 h / N "
        "wide at depth one, and grows with the depth.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 2000; ++i) {
                Random random(1, i);
                const Case it = any_case(random);
                const double bias = task.depth_bias(it.view, it.point, it.plane.normal);
                show(check, it);
                check.that(1.03 * bias >= it.deeper,
                           "a bias of at least " + in_words(it.deeper) +
                               ": so much deeper it lies than its texel's middle",
                           in_words(bias));
            }
        });

    grading.check(
        "no more than is needed",
        "Whatever the bias forgives a point, it also forgives the thing that casts a shadow on it: too much, and "
        "shadows come loose from the foot of what casts them. Three times what the texel's worst corner needs is "
        "allowed here.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 500; ++i) {
                Random random(2, i);
                const Case it = any_case(random);
                const double bias = task.depth_bias(it.view, it.point, it.plane.normal), limit = 3 * it.deepest;
                show(check, it);
                check.that(bias <= limit, "a bias of at most " + in_words(limit), in_words(bias));
            }
        });

    grading.check("finer texels, less bias",
                  "With twice as many texels across, each is half as wide and half of the bias will do.", lesson,
                  [&](Check &check) {
                      for (unsigned i = 0; i < 50; ++i) {
                          Random random(3, i);
                          const Case it = any_case(random);
                          MapView finer = it.view;
                          finer.texels *= 4;
                          const double bias = task.depth_bias(it.view, it.point, it.plane.normal);
                          const double less = task.depth_bias(finer, it.point, it.plane.normal);
                          show(check, it);
                          check.that(less < 0.3 * bias, "with 4096 texels a quarter of " + in_words(bias),
                                     in_words(less));
                      }
                  });

    grading.check(
        "a level surface, stored in float, does not shadow itself",
        "The depths in the map are floats, rounded by up to half of 2^-23 of themselves. That much must be forgiven "
        "even where the surface faces the lamp; and on a level surface hardly more.",
        "Why equal is not equal", [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(4, i);
                Case it = any_case(random);
                it.depth = random.uniform(2, 30);
                it.plane.normal = -it.view.forward;
                it.point = it.view.eye + it.depth * sight(it.view, random.uniform(), random.uniform());
                const double bias = task.depth_bias(it.view, it.point, it.plane.normal);
                const double least = 0x1p-24 * it.depth, most = 0x1p-19 * it.depth;
                show(check, it);
                check.that(bias >= least, "a bias of at least " + in_words(least) + ", for rounding", in_words(bias));
                check.that(bias <= most, "a bias of at most " + in_words(most) + ", for rounding", in_words(bias));
            }
        });

    grading.check("a surface seen edge-on has a finite bias",
                  "There n · d is 0 and the slope without limit. Any bound will do, as long as it is a number.",
                  "Hard cases", [&](Check &check) {
                      Random random(5);
                      Case it = any_case(random);
                      it.view = {{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 0.5, 1024};
                      it.point = {0, 0, -4};
                      it.depth = 4;
                      for (const Vec<double> &normal : {Vec<double>(1, 0, 0), {0, -1, 0}, {0.6, 0.8, 0}}) {
                          it.plane.normal = normal;
                          const double bias = task.depth_bias(it.view, it.point, normal);
                          show(check, it);
                          check.that(bias >= 0 && bias < infinity<double>, "a finite number", in_words(bias));
                      }
                  });
}

} // namespace course
