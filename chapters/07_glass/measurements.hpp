// Lesson 07, the experiments: float near the two limits of Fresnel's equations, and what it costs to model everything.
#pragma once
#include "chapters/06_whitted/bounces.hpp"
#include "chapters/07_glass/everything.hpp"

#include <cmath>

namespace course {

// Two ways to the reflectance, in the scalar T: from Snell's sines and tangents of both angles, as textbooks have it;
// and from cosines, with the refracted one by 1 - sin² (A eq. 50 and 53).
template <class T> T reflectance_by_sines(T i, T n) {
    const T t = std::asin(std::sin(i) / n);
    const T s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
    return (s * s + p * p) / 2;
}
template <class T> T reflectance_by_cosines(T cos_i, T n) {
    const T cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / (n * n));
    const T s = (n * cos_i - cos_t) / (cos_t + n * cos_i), p = (cos_i - n * cos_t) / (n * cos_t + cos_i);
    return (s * s + p * p) / 2;
}

// The relative error of each at the angle i (in radians) from a medium with n_from to one with n_to. All but the first
// are given the cosine in double, as a ray tracer has it; the exact value is that cosine's, in 64 bits of mantissa.
inline Row reflectance_row(const std::string &where, double off, double i, float n_from, float n_to) {
    const double cos_i = std::cos(i);
    const long double from = n_from, to = n_to, c = cos_i,
                      cos_t = std::sqrt((to - from) * (to + from) + from * from * c * c) / to;
    const long double s = (from * c - to * cos_t) / (from * c + to * cos_t),
                      p = (to * c - from * cos_t) / (to * c + from * cos_t);
    const auto exact = static_cast<double>((s * s + p * p) / 2);
    const auto error = [&](double found) { return std::abs(found / exact - 1); };
    const auto i_float = static_cast<float>(i), n_float = n_to / n_from;
    return Row()
        .set("where", where)
        .set("radians off", off)
        .set("sines, float", error(static_cast<double>(reflectance_by_sines(i_float, n_float))))
        .set("eq. 50, float", error(static_cast<double>(reflectance_by_cosines(static_cast<float>(cos_i), n_float))))
        .set("eq. 50, double",
             error(reflectance_by_cosines(cos_i, static_cast<double>(n_to) / static_cast<double>(n_from))))
        .set("ours", error(fresnel(cos_i, n_from, n_to).reflected));
}

inline void measure_fresnel(const Program &program) {
    Report report{"Relative error of the reflectance", {}, {}};
    Plot normal{"Reflectance near normal incidence, air to glass",
                "angle to the normal (radians)",
                "relative error",
                true,
                true,
                {}};
    Plot critical{"Reflectance just before total reflection, glass to air",
                  "radians before the critical angle",
                  "relative error",
                  true,
                  true,
                  {}};
    const double critical_angle = std::asin(1 / 1.5);
    const std::vector<std::string> forms{"sines, float", "eq. 50, float", "eq. 50, double", "ours"};
    for (Plot *plot : {&normal, &critical})
        for (const std::string &form : forms)
            plot->series.push_back({form, {}});
    for (int digits = 1; digits <= 8; ++digits) {
        const double off = std::pow(10.0, -digits);
        const Row rows[]{reflectance_row("normal incidence", off, off, 1, 1.5f),
                         reflectance_row("critical angle", off, critical_angle - off, 1.5f, 1)};
        for (std::size_t k = 0; k < forms.size(); ++k) {
            normal.series[k].points.push_back({off, number(rows[0], forms[k])});
            critical.series[k].points.push_back({off, number(rows[1], forms[k])});
        }
        report.results.insert(report.results.end(), rows, rows + 2);
    }
    report.results.push_back(reflectance_row("normal incidence", 0, 0, 1, 1.5f));
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("fresnel.json"), report);
    write_plot(program.beside_picture("fresnel_normal.svg"), normal);
    write_plot(program.beside_picture("fresnel_critical.svg"), critical);
}

// The time of a world by its own materials, and with the one that can do everything.
template <class AnyWorld>
Row everything_row(const std::string &scene, AnyWorld world, const Limits &limits, const Viewpoint &view) {
    constexpr int width = 240, height = 135;
    world.limits = limits;
    const auto all = with_everything(world);
    const Camera camera(view, width, height);
    Picture by_types, by_all;
    const auto seconds =
        median_seconds({[&] { by_types = plain_picture(scene, world, Path{}, camera, width, height).picture; },
                        [&] { by_all = plain_picture(scene, all, Path{}, camera, width, height).picture; }},
                       9);
    return Row()
        .set("scene", scene)
        .set("own materials (s)", seconds[0])
        .set("everything (s)", seconds[1])
        .set("ratio", seconds[1] / seconds[0])
        .set("pixels changed", changed_pixels(by_types, by_all));
}

} // namespace course
