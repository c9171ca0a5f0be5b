// Grades exercise 07: what is left of light after its way through coloured glass.
#include "exercises/07_absorption/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

namespace course {

namespace {

Colour any_colour(Random &random, double most) {
    const auto channel = [&] { return static_cast<float>(random.uniform(0.1, most)); };
    const float red = channel(), green = channel();
    return {red, green, channel()};
}

Ray<double> any_ray(Random &random, double unit = 1) { return {any_point(random, 3), unit * any_direction(random)}; }

Colour ask(Check &check, const Task &task, const Ray<double> &ray, const std::vector<Layer> &layers) {
    std::vector<Fact> facts{{"ray", ray}};
    for (const Layer &layer : layers)
        facts.insert(facts.end(), {{"layer to t", layer.end}, {"absorption", layer.absorption}});
    check.given(facts);
    return task.light_left(ray, layers);
}

Vec<double> together(const Colour &a, const Colour &b) { return Vec<double>(a) * Vec<double>(b); }

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("07_glass");
    const char *const lesson = "Both sides of a surface";

    grading.check("no medium, or no absorption: all is left",
                  "A clear medium takes nothing away, whatever its thickness.", lesson, [&](Check &check) {
                      Random random(1);
                      check.colour("left", ask(check, task, any_ray(random), {}), Vec<double>(1), 0);
                      check.colour("left", ask(check, task, any_ray(random), {{7, Colour(0)}}), Vec<double>(1), 0);
                  });

    grading.check("each channel by itself",
                  "Coloured glass is coloured because it takes more of one channel than of another.", lesson,
                  [&](Check &check) {
                      Random random(4);
                      const Colour left = ask(check, task, any_ray(random), {{3, Colour(0, 0.5f, 0)}});
                      check.number("left red", left.x, 1, 0);
                      check.number("left blue", left.z, 1, 0);
                      check.that(left.y < 0.5f, "less than half of the green", in_words(double(left.y)));
                  });

    grading.check(
        "twice the way leaves the square",
        "Each piece of the way takes the same share of what arrives there, not the same amount. So the second half "
        "leaves the same share of what the first half has left.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 50; ++i) {
                Random random(2, i);
                const Ray<double> ray = any_ray(random);
                const Colour absorption = any_colour(random, 2);
                const double way = random.uniform(0.2, 2);
                const Colour once = task.light_left(ray, {{way, absorption}});
                const Colour twice = ask(check, task, ray, {{2 * way, absorption}});
                check.colour("left", twice, together(once, once), 32);
                check.that(once.x < 1 && once.x > 0, "less than all and more than nothing", in_words(double(once.x)));
            }
        });

    grading.check("a thin layer takes the absorption times its thickness",
                  "That is what the absorption means: the share that a short way takes, per unit length.", lesson,
                  [&](Check &check) {
                      for (unsigned i = 0; i < 50; ++i) {
                          Random random(3, i);
                          const Colour absorption = any_colour(random, 2);
                          // A million thin layers, so that the small share can be seen in a float.
                          const Colour left = ask(check, task, any_ray(random), {{1, absorption}});
                          Vec<double> expected(1);
                          for (int layer = 0; layer < 1 << 20; layer += 1 << 10) // in steps, to save time
                              expected *= pow(Vec<double>(1) - 0x1p-20 * Vec<double>(absorption), Vec<double>(1 << 10));
                          check.colour("left after a way of 1", left, expected, 64);
                      }
                  });

    grading.check(
        "each layer absorbs over its own thickness",
        "A layer begins where the one before it ends. The order does not matter, and a layer that is cut in two is the "
        "same layer.",
        lesson, [&](Check &check) {
            for (unsigned i = 0; i < 50; ++i) {
                Random random(5, i);
                const Ray<double> ray = any_ray(random);
                const Colour first = any_colour(random, 1), second = any_colour(random, 1);
                const double a = random.uniform(0.2, 1), b = random.uniform(0.2, 1);
                const Colour alone = task.light_left(ray, {{a, first}}), other = task.light_left(ray, {{b, second}});
                check.colour("left", ask(check, task, ray, {{a, first}, {a + b, second}}), together(alone, other), 32);
                check.colour("left", ask(check, task, ray, {{a / 2, first}, {a, first}}), Vec<double>(alone), 32);
            }
        });

    grading.check(
        "the direction may have any length",
        "t counts in lengths of the direction, the absorption in lengths of the scene: the way is t |d|.", lesson,
        [&](Check &check) {
            for (unsigned i = 0; i < 50; ++i) {
                Random random(6, i);
                const Ray<double> ray = any_ray(random);
                const double unit = random.uniform(0.1, 4);
                const Colour absorption = any_colour(random, 1), left = task.light_left(ray, {{1, absorption}});
                check.colour("left", ask(check, task, {ray.origin, unit * ray.direction}, {{1 / unit, absorption}}),
                             Vec<double>(left), 32);
            }
        });

    grading.check(
        "a way without end",
        "A ray that meets nothing has t = infinity. Of a channel that is absorbed nothing is left; of one that is not, "
        "all: but 0 times infinity is NaN, so ask first.",
        lesson, [&](Check &check) {
            Random random(7);
            const Colour left =
                ask(check, task, any_ray(random), {{2, Colour(0)}, {infinity<double>, Colour(0, 1, 0)}});
            check.colour("left", left, Vec<double>(1, 0, 1), 0);
        });
}

} // namespace course
