// Grades exercise 06: mirrors, and when to stop.
#include "exercises/06_reflection/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

namespace course {

namespace {

// The mirror direction must have: the same part along the mirror, the opposite part along the normal.
void ask_direction(Check &check, const Task &task, const Vec<double> &direction, const Vec<double> &normal) {
    check.given({{"direction", direction}, {"normal", normal}});
    const Vec<double> yours = task.mirrored(direction, normal);
    const double size = length(direction), along = dot(yours, normal), before = dot(direction, normal);
    check.that(std::abs(along + before) < 1e-12 * size, "d' · n = " + in_words(-before), in_words(along));
    const Vec<double> moved = cross(yours - direction, normal);
    check.that(length(moved) < 1e-12 * size, "the part of d along the mirror stays", "d' = " + in_words(yours));
}

// A row of places that one ray after another meets, whatever way it goes; after the last, nothing.
struct Row {
    std::vector<Met> places;
    std::size_t asked = 0;

    Meet scene() {
        return [this](const Ray<double> &) -> std::optional<Met> {
            return asked < places.size() ? std::optional(places[asked++]) : (++asked, std::nullopt);
        };
    }
};

Colour any_colour(Random &random, double low, double high) {
    const auto channel = [&] { return static_cast<float>(random.uniform(low, high)); };
    const float red = channel(), green = channel();
    return {red, green, channel()};
}

Row any_row(Random &random, unsigned places) {
    Row row;
    for (unsigned i = 0; i < places; ++i)
        row.places.push_back(
            {any_point(random, 3), any_direction(random), any_colour(random, 0.1, 1), any_colour(random, 0.3, 0.9)});
    return row;
}

// The light of the row by its definition: each glow times all the shares before it.
Vec<double> light_of(const Row &row, unsigned bounces) {
    Vec<double> sum(0), weight(1);
    for (unsigned i = 0; i < row.places.size() && i <= bounces; ++i) {
        sum += weight * Vec<double>(row.places[i].glow);
        weight *= Vec<double>(row.places[i].share);
    }
    return sum;
}

void ask_row(Check &check, const Task &task, Row row, int bounces) {
    std::vector<Fact> facts{{"bounces", bounces}};
    for (const Met &place : row.places)
        facts.insert(facts.end(), {{"glow", place.glow}, {"share", place.share}});
    check.given(facts);
    const Colour light = task.light_along({{0, 0, 0}, {0, 0, -1}}, row.scene(), bounces);
    check.colour("light", light, light_of(row, static_cast<unsigned>(bounces)), 32);
}

// Two mirrors that face each other, at z = 0 and z = 1, and their glow.
std::optional<Met> between_mirrors(const Ray<double> &ray) {
    const double z = ray.direction.z > 0 ? 1 : 0, t = (z - ray.origin.z) / ray.direction.z;
    if (!(t > 1e-9))
        return {};
    return Met{point_at(ray, t), {0, 0, 1}, Colour(1, 0.5f, 0.25f), Colour(0.5f)};
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("06_whitted");
    const char *const direction = "The mirror direction", *const idea = "The idea: the same question again",
                      *const stop = "When to stop";

    grading.check("the ray leaves at the angle at which it came",
                  "Split d into the part along the normal, (d · n) n, and the rest. The mirror turns the first over "
                  "and keeps the "
                  "second. Taking the first away once leaves nothing of it; turning it over takes it twice.",
                  direction, [&](Check &check) {
                      for (unsigned i = 0; i < 100; ++i) {
                          Random random(1, i);
                          const Vec<double> normal = any_direction(random), d = any_direction(random);
                          ask_direction(check, task, dot(d, normal) < 0 ? d : -d, normal);
                      }
                  });

    grading.check(
        "the normal may point to either side",
        "d' = d - 2 (d · n) n has n twice, so turning it around changes nothing. Nothing is gained by taking the sign "
        "off the cosine, and the mirror's back is lost by it.",
        direction, [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(2, i);
                const Vec<double> normal = any_direction(random), d = any_direction(random);
                ask_direction(check, task, dot(d, normal) > 0 ? d : -d, normal);
            }
        });

    grading.check(
        "the direction keeps its length",
        "Kernels do not need a direction of length one, and t counts in its lengths. The formula keeps the length by "
        "itself.",
        direction, [&](Check &check) {
            for (unsigned i = 0; i < 100; ++i) {
                Random random(3, i);
                ask_direction(check, task, random.uniform(0.01, 50) * any_direction(random), any_direction(random));
            }
        });

    grading.check(
        "without a mirror, a place shows its own light",
        "What the ray meets glows, and its own light comes to the eye as it is, whatever share it mirrors. A ray that "
        "meets nothing sees black.",
        idea, [&](Check &check) {
            for (unsigned i = 0; i < 20; ++i) {
                Random random(4, i);
                Row row = any_row(random, i % 2);
                for (Met &place : row.places)
                    place.share = Colour(0);
                ask_row(check, task, row, 5);
            }
        });

    grading.check("what the mirror shows is added, times its share",
                  "A place's own light comes to the eye as it is. Only what it mirrors is weakened by its share.", idea,
                  [&](Check &check) {
                      for (unsigned i = 0; i < 20; ++i) {
                          Random random(5, i);
                          ask_row(check, task, any_row(random, 2), 5);
                      }
                  });

    grading.check("after many mirrors, the shares multiply",
                  "Each mirror takes its share of all that comes after it. The product so far is the ray's weight.",
                  stop, [&](Check &check) {
                      for (unsigned i = 0; i < 20; ++i) {
                          Random random(6, i);
                          ask_row(check, task, any_row(random, 7), 9);
                      }
                  });

    grading.check("each ray starts at the mirror and leaves in the mirror direction",
                  "The next ray is {point, mirrored direction}: the point that was met, not the old origin.", idea,
                  [&](Check &check) {
                      const Ray<double> first{{0, 0, 0.5}, {0.3, 0.4, 1}};
                      Ray<double> expected = first;
                      const Meet scene = [&](const Ray<double> &ray) {
                          check.given({{"ray", ray}});
                          check.vector("origin", ray.origin, expected.origin, 64);
                          check.vector("direction", ray.direction, expected.direction, 64);
                          const auto met = between_mirrors(ray);
                          expected = {met->point, {0.3, 0.4, -ray.direction.z}};
                          return met;
                      };
                      task.light_along(first, scene, 5);
                  });

    grading.check("no more bounces than allowed",
                  "With no bounce allowed, only the first place is seen; with k, at most k + 1 places.", stop,
                  [&](Check &check) {
                      for (const int bounces : {0, 1, 4}) {
                          std::size_t asked = 0;
                          const Meet scene = [&](const Ray<double> &ray) {
                              if (++asked > 1000)
                                  check.fail("an end", "more than 1000 bounces");
                              return between_mirrors(ray);
                          };
                          check.given({{"bounces", bounces}});
                          task.light_along({{0, 0, 0.5}, {0, 0, 1}}, scene, bounces);
                          check.at_most("places looked at", asked, static_cast<std::size_t>(bounces) + 1);
                      }
                  });

    grading.check(
        "a ray that carries nothing is not sent",
        "Where the weight has become 0, nothing that follows can change the picture. Most surfaces mirror nothing, so "
        "this saves most rays.",
        stop, [&](Check &check) {
            Random random(9);
            Row row = any_row(random, 6);
            row.places[2].share = Colour(0);
            check.given({{"share of the third place", Colour(0)}, {"bounces", 9}});
            task.light_along({{0, 0, 0}, {0, 0, -1}}, row.scene(), 9);
            check.at_most("places looked at", row.asked, 3);
        });
}

} // namespace course
