// Grades exercise 17: the sphere's test in GLSL.
#include "exercises/17_glsl_sphere/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/shader_runs.hpp"
#include "tests/oracle/shapes.hpp"

#include <cmath>
#include <vector>

namespace course {

namespace {

constexpr double allowed = 0x1p37; // ulp of a double: 256 of a float

struct Case {
    Ray<double> ray; // of numbers that a float can hold
    Sphere<float> sphere;
};

Vec<double> rounded(const Vec<double> &v) { return Vec<double>(Vec<float>(v)); }

Texel texel(const Vec<double> &v, float w) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), w};
}

// All cases in one picture, three texels for each: origin, direction, sphere.
void ask(Check &check, const Task &task, const std::vector<Case> &cases) {
    std::vector<Texel> texels;
    for (const auto &[ray, sphere] : cases)
        texels.insert(texels.end(), {texel(ray.origin, 0), texel(ray.direction, 0),
                                     texel(Vec<double>(sphere.centre), sphere.radius)});
    const auto results = run_answer(check, task, "", R"(void main() {
    int at = 3 * int(gl_FragCoord.x);
    vec4 sphere = texelFetch(cases, at + 2);
    result = vec4(hit_sphere(texelFetch(cases, at).xyz, texelFetch(cases, at + 1).xyz, sphere.xyz, sphere.w));
})",
                                    texels, static_cast<int>(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto &[ray, sphere] = cases[i];
        check.given({{"ray", ray}, {"centre", sphere.centre}, {"radius", sphere.radius}});
        const double t = static_cast<double>(results[i][0]);
        check.hit(t == -1 ? std::optional<double>() : std::optional(t), exact::answer(ray, sphere), allowed);
    }
}

// How far the ray passes the centre, in radii.
double aside(const Case &one) {
    const Vec<double> to_centre = Vec<double>(one.sphere.centre) - one.ray.origin;
    return length(cross(to_centre, normalize(one.ray.direction))) / static_cast<double>(one.sphere.radius);
}

} // namespace

void grade(const Task &task, Grading &grading) {
    const auto question = [](const char *name, const char *why) {
        return Question{name, why, "17_gpu", "The idea: one triangle, and a ray for each pixel"};
    };
    const auto check = [&](const char *name, const char *why, const auto &any_case) {
        grading.check(question(name, why), [&](Check &asked) {
            std::vector<Case> cases;
            for (unsigned i = 0; cases.size() < 300; ++i) {
                Random random(7, i);
                Case one = any_case(random);
                one.ray.origin = rounded(one.ray.origin);
                one.ray.direction = rounded(one.ray.direction);
                if (std::abs(aside(one) - 1) > 0.1)
                    cases.push_back(one);
            }
            ask(asked, task, cases);
        });
    };
    const Sphere<float> ball{{0.5, -0.25, 1}, 1.5};

    check(
        "a sphere ahead is met at its near side, one beside it is missed",
        "It is chapter 01's formula, now in float: the discriminant decides, the smaller root comes first, and -1 says "
        "that there is no hit.",
        [&](Random &random) {
            const Vec<double> origin = Vec<double>(ball.centre) + 4. * any_direction(random);
            const Vec<double> target = Vec<double>(ball.centre) + any_point(random, 1.6);
            return Case{{origin, normalize(target - origin)}, ball};
        });
    check("the direction may have any length", "t counts in lengths of d, so a = d · d stays in the formula.",
          [&](Random &random) {
              const Vec<double> origin = Vec<double>(ball.centre) + 4. * any_direction(random);
              const Vec<double> target = Vec<double>(ball.centre) + any_point(random, 0.7);
              return Case{{origin, random.uniform(0.2, 3) * (target - origin)}, ball};
          });
    check("from inside, the far side is met", "The near root is negative there; then the far one counts.",
          [&](Random &random) {
              return Case{{Vec<double>(ball.centre) + any_point(random, 0.7), any_direction(random)}, ball};
          });
    check("a sphere behind the origin is not met", "Both roots are negative: the answer is -1.", [&](Random &random) {
        const Vec<double> out = any_direction(random);
        return Case{{Vec<double>(ball.centre) + 3. * out, normalize(out + 0.1 * any_direction(random))}, ball};
    });
    check("a small sphere far away is met where it is",
          "b² and ac are both about the square of the distance, and their difference is all that is left of the "
          "radius: in "
          "float, nothing. The cross product of the direction with the way to the centre is the miss distance itself.",
          [&](Random &random) {
              const Vec<double> origin = 3000. * any_direction(random);
              const Vec<double> target = Vec<double>(ball.centre) + any_point(random, 1.3);
              return Case{{rounded(origin), normalize(target - rounded(origin))}, ball};
          });
}

} // namespace course
