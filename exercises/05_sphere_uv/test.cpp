// Grades exercise 05: where on a globe a point lies.
#include "exercises/05_sphere_uv/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

namespace course {

namespace {

MapPlace ask(Check &check, const Task &task, const Vec<double> &direction) {
    check.given({{"direction", direction}});
    return task.on_globe(direction);
}

// The way back: longitude and latitude to a direction of length one.
Vec<double> direction_at(const MapPlace &place) {
    const double longitude = 2 * pi * place.u, from_north = pi * (1 - place.v);
    return {std::sin(from_north) * std::cos(longitude), std::cos(from_north),
            -std::sin(from_north) * std::sin(longitude)};
}

void there_and_back(Check &check, const Task &task, const Vec<double> &direction) {
    const MapPlace place = ask(check, task, direction);
    const Vec<double> back = direction_at(place), should = normalize(direction);
    check.that(length(back - should) < 1e-14, "the place on the map that leads back to " + in_words(should),
               "u = " + in_words(place.u) + ", v = " + in_words(place.v) + " leads to " + in_words(back));
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("05_texture");
    const char *const table = "The coordinates, shape by shape", *const angle = "The angle around an axis";

    grading.check("the four winds",
                  "u is 0 towards x and grows towards -z, a quarter for each turn of 90 degrees: seen from outside "
                  "with y up, the "
                  "map runs to the right. On the equator v is one half.",
                  table, [&](Check &check) {
                      const Vec<double> winds[] = {{1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}};
                      for (int i = 0; i < 4; ++i) {
                          const MapPlace place = ask(check, task, winds[i]);
                          check.number("u", place.u - std::floor(place.u), 0.25 * i, 4);
                          check.number("v", place.v, 0.5, 4);
                      }
                  });

    grading.check(
        "all the way round, u runs from 0 to 1",
        "The arctangent of two numbers runs from -pi to pi. Where it is negative, a whole turn is to be added.", angle,
        [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(2, i);
                const MapPlace place = ask(check, task, any_direction(random));
                check.that(place.u >= 0 && place.u <= 1, "u from 0 to 1", "u = " + in_words(place.u));
                there_and_back(check, task, any_direction(random));
            }
        });

    grading.check("the direction may have any length",
                  "Arctangents of two coordinates do not mind the length; an arc cosine does, and is NaN beyond 1.",
                  angle, [&](Check &check) {
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(3, i);
                          there_and_back(check, task, random.uniform(0.01, 100) * any_direction(random));
                      }
                  });

    grading.check("v is exactly 0 and 1 at the poles",
                  "There the distance from the axis is 0 and the arctangent exact.", angle, [&](Check &check) {
                      for (const double size : {1., 7., 1e-3}) {
                          check.number("v", ask(check, task, {0, size, 0}).v, 1, 0);
                          check.number("v", ask(check, task, {0, -size, 0}).v, 0, 0);
                      }
                  });

    grading.check("near the poles no digits are lost",
                  "The cosine of a small angle is nearly 1 whatever the angle is, so its arc cosine knows only half of "
                  "the digits. "
                  "Take the latitude as an arctangent, too: of the distance from the axis and the height.",
                  angle, [&](Check &check) {
                      for (const double tilt : {1e-3, 1e-5, 1e-7})
                          for (const double up : {1., -1.})
                              there_and_back(check, task, {0.6 * tilt, up, 0.8 * tilt});
                  });

    grading.check(
        "u is never 1",
        "A picture's columns end before 1. A very small negative turn, plus 1, is rounded to exactly 1; it belongs to "
        "column 0.",
        angle, [&](Check &check) {
            for (const double z : {1e-15, 1e-17, 1e-20, 1e-300}) {
                const MapPlace place = ask(check, task, {1, 0.5, z});
                check.that(place.u >= 0 && place.u < 1, "0 <= u < 1", "u = " + in_words(place.u));
            }
        });
}

} // namespace course
