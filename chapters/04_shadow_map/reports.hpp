// Lesson 04, the experiments' tables and plots.
#pragma once
#include "chapters/04_shadow_map/measure.hpp"
#include "common/publish.hpp"

namespace course {

// One curve of a plot: a column against another.
inline Series curve(const std::vector<Row> &rows, const char *x, const char *y, const char *name) {
    Series series{name, {}};
    const auto number = [](const Value &value) {
        const auto *whole = std::get_if<std::int64_t>(&value);
        return whole ? static_cast<double>(*whole) : std::get<double>(value);
    };
    for (const Row &row : rows)
        series.points.push_back({number(*row.find(x)), number(*row.find(y))});
    return series;
}

inline void measure_shadow_maps(const Program &program) {
    use_threads(1);
    const SundialScene scene = sundial_scene();
    const auto cases = sundial_cases(scene, 640, 360);
    const auto publish_rows = [&](const char *suffix, const char *title, std::vector<Row> rows, Plot plot) {
        publish(program, suffix, {title, Row().set("cases", static_cast<int>(cases.size())), std::move(rows)}, plot);
    };

    const auto rows = measure_resolutions(scene, cases);
    const char *x = "resolution";
    publish_rows("error", "Error and time against the map's resolution", rows,
                 {"Pixels that a shadow map gets wrong",
                  "texels a side",
                  "wrong per million",
                  true,
                  true,
                  {curve(rows, x, "false_shadow_ppm", "shadow where light is"),
                   curve(rows, x, "false_light_ppm", "light where shadow is")}});
    write_plot(program.beside_picture("time.svg"),
               {"One shadow for each pixel",
                "texels a side",
                "ms on one core",
                true,
                true,
                {curve(rows, x, "make_ms", "to make the map"), curve(rows, x, "look_up_ms", "to look it up"),
                 curve(rows, x, "shadow_rays_ms", "shadow rays instead")}});

    auto biases = measure_biases(scene, cases);
    const std::vector<Row> sloped(biases.begin() + 4, biases.end());
    publish_rows("bias", "What the bias is for", biases,
                 {"The price of a bias, 512 texels a side",
                  "slope of the bias, in texels",
                  "wrong per million",
                  false,
                  true,
                  {curve(sloped, "slope", "false_shadow_ppm", "shadow where light is"),
                   curve(sloped, "slope", "false_light_ppm", "light where shadow is")}});

    const auto penumbras = measure_penumbras();
    publish_rows("penumbra", "Width of the penumbra", penumbras,
                 {"Width of the penumbra",
                  "height of the edge",
                  "width on the floor",
                  false,
                  false,
                  {curve(penumbras, "edge_height", "lamp", "of a lamp 0.8 wide"),
                   curve(penumbras, "edge_height", "filter_0", "map, no filter"),
                   curve(penumbras, "edge_height", "filter_4", "map, 9 x 9 texels"),
                   curve(penumbras, "edge_height", "filter_12", "map, 25 x 25 texels")}});
}

} // namespace course
