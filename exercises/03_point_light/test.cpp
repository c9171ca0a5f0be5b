// Grades exercise 03: the light of a point lamp.
#include "exercises/03_point_light/task.hpp"

#include "exercises/grading/cases.hpp"
#include "exercises/grading/grading.hpp"

namespace course {

namespace {

const Blocked nothing = [](const Ray<double> &) { return false; };

// A ball, asked by exact arithmetic.
Blocked ball(const Vec<double> &centre, double radius) {
    return [=](const Ray<double> &ray) { return exact::sphere(ray, centre, radius).may_hit(); };
}

struct Setting {
    Vec<double> point, normal;
    Lamp lamp;
};

void show(Check &check, const Setting &it) {
    check.given(
        {{"point", it.point}, {"normal", it.normal}, {"lamp", it.lamp.position}, {"intensity", it.lamp.intensity}});
}

Setting any_setting(Random &random) {
    const Vec<double> point = any_point(random, 5), up = any_direction(random);
    const double distance = random.uniform(0.3, 8);
    return {
        point, up, {point + distance * up, Colour(random.uniform(1, 2), random.uniform(2, 4), random.uniform(4, 9))}};
}

// The setting with the surface turned, so that the light arrives at this angle to the normal.
Setting turned(Setting it, Random &random, double angle) {
    const Vec<double> aside = normalize(cross(it.normal, any_direction(random)));
    it.normal = std::cos(angle) * it.normal + std::sin(angle) * aside;
    return it;
}

Vec<double> on_the_way(const Setting &it, double share) { return it.point + share * (it.lamp.position - it.point); }

Colour ask(const Task &task, const Setting &it, const Blocked &blocked = nothing) {
    return task.lamp_light(it.point, it.normal, it.lamp, blocked);
}

void for_settings(std::uint64_t seed, auto visit) {
    for (unsigned i = 0; i < 100; ++i) {
        Random random(seed, i);
        visit(random, any_setting(random));
    }
}

} // namespace

void grade(const Task &task, Grading &grading) {
    grading.lesson("03_light_and_shadow");
    const char *const lesson = "How bright: three factors and one missing";

    grading.check("at distance one, facing the lamp: its intensity",
                  "That is what the intensity means. There is no other constant in it.", lesson, [&](Check &check) {
                      for_settings(1, [&](Random &, Setting it) {
                          it.lamp.position = it.point + it.normal;
                          show(check, it);
                          check.colour("light", ask(task, it), Vec<double>(it.lamp.intensity));
                      });
                  });

    grading.check(
        "twice as far, a quarter of the light",
        "The same light passes through every sphere around the lamp, and the area of a sphere grows with the square "
        "of its radius. So the light of all of them, area times brightness, must be the same.",
        lesson, [&](Check &check) {
            for_settings(2, [&](Random &, const Setting &it) {
                Setting near = it;
                near.lamp.position = on_the_way(it, 0.5);
                show(check, it);
                check.colour("light from the lamp here", ask(task, it), 0.25 * Vec<double>(ask(task, near)), 64);
            });
        });

    grading.check(
        "aslant, the light spreads over more of the surface",
        "A beam that meets the surface at an angle covers 1 / cos as much of it. The cosine is the product of the "
        "normal and the direction to the lamp, both of length one.",
        lesson, [&](Check &check) {
            for_settings(3, [&](Random &random, const Setting &it) {
                const double angle = random.uniform(0.2, 1.4);
                const Setting aslant = turned(it, random, angle);
                show(check, aslant);
                check.colour("light", ask(task, aslant), std::cos(angle) * Vec<double>(ask(task, it)), 64);
            });
        });

    grading.check(
        "a surface turned away stays dark",
        "Where the cosine is negative the lamp is behind the surface. Its sign is the answer; do not take it off.",
        lesson, [&](Check &check) {
            for_settings(4, [&](Random &random, const Setting &it) {
                const Setting away = turned(it, random, random.uniform(1.7, 3.1));
                show(check, away);
                check.colour("light", ask(task, away), Vec<double>(0));
            });
        });

    grading.check("what stands between casts a shadow",
                  "Send a ray from the point towards the lamp. If it is blocked, none of this lamp's light arrives.",
                  "Shadow rays", [&](Check &check) {
                      for_settings(5, [&](Random &random, const Setting &it) {
                          const Vec<double> centre = on_the_way(it, random.uniform(0.3, 0.7));
                          show(check, it);
                          check.colour("light, with a ball of radius 0.05 on the way",
                                       ask(task, it, ball(centre, 0.05)), Vec<double>(0));
                      });
                  });

    grading.check(
        "what stands behind the lamp casts no shadow",
        "The shadow ray ends at the lamp: its t_max. t counts in lengths of the direction, so with a direction of "
        "length one t_max is the distance, and with the whole way to the lamp it is 1.",
        "Shadow rays", [&](Check &check) {
            for_settings(6, [&](Random &random, const Setting &it) {
                const Vec<double> centre = on_the_way(it, random.uniform(1.2, 3));
                show(check, it);
                check.colour("light, with a ball of radius 0.03 behind the lamp", ask(task, it, ball(centre, 0.03)),
                             Vec<double>(ask(task, it)));
            });
        });

    grading.check("what stands behind the point casts no shadow",
                  "The ray goes from the point to the lamp, and only forwards.", "Shadow rays", [&](Check &check) {
                      for_settings(7, [&](Random &random, const Setting &it) {
                          const Vec<double> centre = on_the_way(it, -random.uniform(0.5, 3));
                          show(check, it);
                          check.colour("light, with a ball of radius 0.1 behind the point",
                                       ask(task, it, ball(centre, 0.1)), Vec<double>(ask(task, it)));
                      });
                  });

    grading.check(
        "where no light can come from, no shadow ray is sent",
        "Shadow rays are most of the work of a picture. Ask for the cosine first: half of all lamps are behind the "
        "surface.",
        "Shadow rays", [&](Check &check) {
            std::size_t rays = 0, lit = 0;
            const Blocked counting = [&](const Ray<double> &) { return ++rays, false; };
            for_settings(8, [&](Random &random, const Setting &it) {
                const double angle = random.uniform(0, 3.1);
                lit += std::cos(angle) > 0;
                ask(task, turned(it, random, angle), counting);
            });
            check.given({{"lamps", 100}, {"in front", lit}});
            check.at_most("shadow rays", rays, lit);
        });
}

} // namespace course
