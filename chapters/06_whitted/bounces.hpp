// Lesson 06, the experiment: what a bounce more is worth, and what the early end saves.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/06_whitted/whitted.hpp"
#include "common/image_difference.hpp"
#include "common/image_files.hpp"
#include "common/plot.hpp"
#include "common/program.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <cstdio>
#include <string>

namespace course {

// The picture of a world with one ray through the middle of each pixel, so that nothing but the limits differs.
template <class AnyWorld, class StartPath> RenderedPicture plain_picture(const std::string &label,
                                                                         const AnyWorld &world, const StartPath &start,
                                                                         const Camera &camera, int width, int height) {
    return render_picture(label, width, height, each_pixel([&](int x, int y) {
                              Random random(1, static_cast<std::uint64_t>(y * width + x));
                              return radiance(camera.ray(x + 0.5, y + 0.5), world, start, random);
                          }));
}

// How many pixels are not the same any more once they are written in 8 bits.
inline int changed_pixels(const Picture &a, const Picture &b) {
    const auto same = [](const Colour &p, const Colour &q) {
        return srgb_byte(p.r) == srgb_byte(q.r) && srgb_byte(p.g) == srgb_byte(q.g) && srgb_byte(p.b) == srgb_byte(q.b);
    };
    int changed = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        changed += !same(a.pixels[i], b.pixels[i]);
    return changed;
}

// One row for each of some limits: time, rays, and how far the picture is from the one with the last of the limits.
template <class AnyWorld, class StartPath>
std::vector<Row> compare_limits(const std::string &scene, AnyWorld world, const StartPath &start, const Viewpoint &view,
                                const std::vector<Limits> &all_limits) {
    constexpr int width = 320, height = 180;
    const Camera camera(view, width, height);
    std::vector<RenderedPicture> pictures;
    std::vector<std::function<void()>> renders;
    for (const Limits &limits : all_limits)
        renders.push_back([&, limits] {
            world.limits = limits;
            pictures.push_back(plain_picture(scene, world, start, camera, width, height));
        });
    const std::vector<double> seconds = median_seconds(renders, 3);

    std::vector<Row> rows;
    const std::size_t count = all_limits.size();
    for (std::size_t i = 0; i < count; ++i) {
        const ImageDifference apart = difference(pictures[i].picture, pictures[count - 1].picture);
        rows.push_back(Row()
                           .set("scene", scene)
                           .set("bounces", all_limits[i].bounces)
                           .set("least weight", static_cast<double>(all_limits[i].least_weight))
                           .set("seconds", seconds[i])
                           .set("rays per pixel", static_cast<double>(pictures[i].rays) / (width * height))
                           .set("error (1/255)", apart.rmse_steps)
                           .set("pixels changed", changed_pixels(pictures[i].picture, pictures[count - 1].picture)));
    }
    return rows;
}

// The limits 1, 2, 4 ... 32, and one that no ray reaches.
inline std::vector<Limits> growing_limits() {
    std::vector<Limits> limits;
    for (const int bounces : {1, 2, 4, 8, 16, 32, 512})
        limits.push_back({.bounces = bounces});
    return limits;
}

// The same bounces, ended early at several weights or not at all.
inline std::vector<Limits> growing_patience(int bounces) {
    std::vector<Limits> limits;
    for (const float weight : {0x1p-8f, 0x1p-12f, 0x1p-16f, 0x1p-20f, 0x1p-26f, 0.0f})
        limits.push_back({.bounces = bounces, .least_weight = weight});
    return limits;
}

inline double number(const Row &row, const std::string &name) {
    const Value &value = *row.find(name);
    return std::holds_alternative<double>(value) ? std::get<double>(value)
                                                 : static_cast<double>(std::get<std::int64_t>(value));
}

// Prints the rows and writes them beside the picture, with a plot of error and time against bounces.
inline void report_bounces(const Program &program, const std::vector<std::vector<Row>> &scenes) {
    Report report{"Error and time against the bounce limit", {}, {}};
    Plot error{"Error against the bounce limit", "bounces", "RMSE in steps of 1/255", true, true, {}};
    Plot time{"Time against the bounce limit", "bounces", "seconds", true, false, {}};
    for (const auto &rows : scenes) {
        const std::string scene = std::get<std::string>(*rows.front().find("scene"));
        Series errors{scene, {}}, times{scene, {}};
        for (const Row &row : rows) {
            if (number(row, "bounces") < 100)
                errors.points.push_back({number(row, "bounces"), number(row, "error (1/255)")});
            times.points.push_back({number(row, "bounces"), number(row, "seconds")});
            report.results.push_back(row);
        }
        error.series.push_back(errors);
        time.series.push_back(times);
    }
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("bounces.json"), report);
    write_plot(program.beside_picture("bounces_error.svg"), error);
    write_plot(program.beside_picture("bounces_time.svg"), time);
}

inline void report_early_end(const Program &program, const std::vector<Row> &rows) {
    std::printf("%s\n", terminal_table(rows).c_str());
    write_json(program.beside_picture("early_end.json"), {"Ending rays that no longer count", {}, rows});
}

} // namespace course
