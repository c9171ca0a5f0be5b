// Grades exercise 01: where a ray meets a sphere.
#include "exercises/01_sphere_roots/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"
#include "tests/oracle/shapes.hpp"

namespace course {

namespace {

Sphere<float> any_sphere(Random &random) {
    return {Vec<float>(any_point(random, 3)), static_cast<float>(random.uniform(0.5, 2))};
}

// A point on the sphere stretched or shrunk about its centre.
Vec<double> around(const Sphere<float> &sphere, Random &random, double stretch) {
    return Vec<double>(sphere.centre) + stretch * double(sphere.radius) * any_direction(random);
}

// Whether the ray passes so near the rim that any rounding shows.
bool grazes(const Ray<double> &ray, const Sphere<float> &sphere) {
    const Vec<double> miss = cross(Vec<double>(sphere.centre) - ray.origin, normalize(ray.direction));
    return std::abs(length(miss) / double(sphere.radius) - 1) < 0.05;
}

void ask(Check &check, const Task &task, const Ray<double> &ray, const Sphere<float> &sphere) {
    check.given({{"ray", ray}, {"centre", sphere.centre}, {"radius", sphere.radius}});
    check.hit(task.sphere_hit(ray, sphere), exact::answer(ray, sphere));
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("01_ray_casting");
    const char *const textbook = "A sphere, the textbook way";

    grading.check("a sphere ahead is met at its near side, one beside it is missed",
                  "Put o + t d in place of p in |p - c|² = R² and sort by powers of t. A negative discriminant is a "
                  "miss; else the smaller root comes first.",
                  textbook, [&](Check &check) {
                      for (unsigned i = 0; i < 300; ++i) {
                          Random random(1, i);
                          const Sphere<float> sphere = any_sphere(random);
                          const Vec<double> origin = around(sphere, random, random.uniform(2, 4));
                          const Ray<double> ray{origin, normalize(around(sphere, random, 1.3) - origin)};
                          if (!grazes(ray, sphere))
                              ask(check, task, ray, sphere);
                      }
                  });

    grading.check(
        "the direction may have any length",
        "t counts in lengths of d, so a = d · d stays in the formula; normalising the direction gives "
        "another t than the one that was asked for.",
        "A ray", [&](Check &check) {
            for (unsigned i = 0; i < 300; ++i) {
                Random random(2, i);
                const Sphere<float> sphere = any_sphere(random);
                const Vec<double> origin = around(sphere, random, random.uniform(2, 4));
                ask(check, task, {origin, random.uniform(0.1, 3) * (around(sphere, random, 0.8) - origin)}, sphere);
            }
        });

    grading.check(
        "from inside, the far side is met",
        "Seen from inside, the near root lies behind the origin and only the far one counts: try both "
        "roots, the smaller one first, and take the first that lies in the ray's interval.",
        textbook, [&](Check &check) {
            for (unsigned i = 0; i < 200; ++i) {
                Random random(3, i);
                const Sphere<float> sphere = any_sphere(random);
                ask(check, task, {around(sphere, random, random.uniform(0, 0.9)), any_point(random, 1)}, sphere);
            }
        });

    grading.check("a sphere behind the origin is not met",
                  "Both roots are negative there. The ray is half a line: t must be larger than t_min.", "A ray",
                  [&](Check &check) {
                      for (unsigned i = 0; i < 100; ++i) {
                          Random random(4, i);
                          const Sphere<float> sphere = any_sphere(random);
                          const Vec<double> origin = around(sphere, random, 2);
                          ask(check, task, {origin, origin - around(sphere, random, 0.9)}, sphere);
                      }
                  });

    grading.check(
        "a hit counts only inside the ray's interval",
        "t_min < t < t_max, both ends excluded: in_range(ray, t) says it. Where the near root is out of it, "
        "the far one may still be in.",
        "A ray", [&](Check &check) {
            const Sphere<float> sphere{{0, 0, 0}, 1}; // roots at 2 and 4
            for (const auto &[t_min, t_max] :
                 {std::pair{1., 3.}, {2., 9.}, {2.5, 9.}, {0., 2.}, {0., 1.5}, {2., 4.}, {3., 3.5}, {4., 9.}, {5., 9.}})
                ask(check, task, {{0, 0, 3}, {0, 0, -1}, t_min, t_max}, sphere);
        });

    grading.check("a ray that just touches the sphere meets it",
                  "The discriminant is exactly zero here, and the two roots are one. A strict comparison calls that a "
                  "miss; the sphere is closed, its rim belongs to it.",
                  textbook, [&](Check &check) {
                      for (unsigned i = 0; i < 100; ++i) { // whole numbers throughout, so nothing is rounded
                          Random random(6, i);
                          const auto whole = [&](int most) {
                              return static_cast<double>(random.bits() % unsigned(most) + 1);
                          };
                          const Vec<double> centre(whole(9), -whole(9), whole(9));
                          const double radius = whole(20), distance = whole(30);
                          const Sphere<float> sphere{Vec<float>(centre), static_cast<float>(radius)};
                          ask(check, task, {centre + Vec<double>(radius, 0, distance), {0, 0, -1}}, sphere);
                          ask(check, task, {centre + Vec<double>(-distance, 0, -radius), {2, 0, 0}}, sphere);
                      }
                  });

    grading.check("close to the surface no digits are lost",
                  "The root near the surface is a small difference of two large numbers, -b and the square root, and "
                  "keeps only their rounding errors. Compute the root that adds, and get this one from the product of "
                  "the roots, c / a.",
                  "A sphere, the way that does not cancel", [&](Check &check) {
                      const Sphere<float> sphere{{0, 0, 0}, 4096};
                      for (unsigned i = 0; i < 200; ++i) {
                          Random random(7, i);
                          const Vec<double> up = any_direction(random);
                          const double height = (i % 2 ? 1 : -1) * random.uniform(0.02, 0.1);
                          // A multiple of 1/256, so that |o|² - R² is exact.
                          const Vec<double> origin = round((4096 + height) * up * 256.) / 256.;
                          const Vec<double> along = any_direction(random) + (i % 2 ? -2. : 2.) * up;
                          ask(check, task, {origin, along}, sphere);
                      }
                  });

    grading.check("where a number is no number, there is no hit",
                  "Every comparison with NaN is false. So write conditions that accept, !(discriminant >= 0), and not "
                  "ones that reject, discriminant < 0: else a hit at t = NaN is reported.",
                  "A sphere, the way that does not cancel", [&](Check &check) {
                      const double none = std::numeric_limits<double>::quiet_NaN();
                      const Sphere<float> sphere{{0, 0, 0}, 1};
                      for (const Ray<double> &ray : {Ray<double>{{0, 0, 3}, {0, 0, 0}},
                                                     {{0, 0, 3}, {none, 0, -1}},
                                                     {{0, none, 3}, {0, 0, -1}},
                                                     {{0, 0, 3}, {0, 0, infinity<double>}},
                                                     {{0, 0, infinity<double>}, {0, 0, -1}}}) {
                          check.given({{"ray", ray}, {"centre", sphere.centre}, {"radius", sphere.radius}});
                          check.hit(task.sphere_hit(ray, sphere), {});
                      }
                  });
}

} // namespace course
