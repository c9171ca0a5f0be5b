// Lesson 04, the experiments: where a shadow map is wrong, what it costs (claim C13), and what it cannot do (C19).
#pragma once
#include "chapters/04_shadow_map/cases.hpp"
#include "common/report.hpp"
#include "common/timing.hpp"

#include <string>

namespace course {

// Error and time against the resolution. The times are those of one shadow for each case, with the map's making.
inline std::vector<Row> measure_resolutions(const SundialScene &scene, const std::vector<MapCase> &cases) {
    const LightView view(lamp_view);
    const Vec<double> lamp = lamp_point().position;
    std::vector<Row> rows;
    for (int resolution = 64; resolution <= 2048; resolution *= 2) {
        const ShadowMap map(scene, view, resolution);
        const MapErrors errors = errors_of(map, {}, cases);
        const auto seconds =
            median_seconds({[&] { keep(ShadowMap(scene, view, resolution)); }, [&] { keep(errors_of(map, {}, cases)); },
                            [&] {
                                for (const MapCase &c : cases)
                                    keep(any_hit(Ray<double>{lamp, c.point - lamp, 0, 1 - 1e-9}, scene));
                            }},
                           resolution < 1024 ? 3 : 1);
        rows.push_back(Row()
                           .set("resolution", resolution)
                           .set("false_shadow_ppm", errors.false_shadow)
                           .set("false_light_ppm", errors.false_light)
                           .set("make_ms", 1e3 * seconds[0])
                           .set("look_up_ms", 1e3 * seconds[1])
                           .set("shadow_rays_ms", 1e3 * seconds[2]));
    }
    return rows;
}

// What the comparison is off by: the rounding to float, and the texel's width.
inline std::vector<Row> measure_biases(const SundialScene &scene, const std::vector<MapCase> &cases) {
    const int resolution = 512;
    const LightView view(lamp_view);
    const ShadowMap map(scene, view, resolution);
    const auto middles = texel_cases<double>(scene, view, resolution);
    const auto in_float = texel_cases<float>(scene, view, resolution);
    std::vector<Row> rows;
    const auto row = [&](const char *points, const std::vector<MapCase> &of, double ulps, double slope) {
        const MapErrors errors = errors_of(map, {.slope = slope, .ulps = ulps}, of);
        rows.push_back(Row()
                           .set("points", points)
                           .set("ulps", ulps)
                           .set("slope", slope)
                           .set("false_shadow_ppm", errors.false_shadow)
                           .set("false_light_ppm", errors.false_light));
    };
    row("middles of texels", middles, 0, 0);
    row("the same, stored in float", in_float, 0, 0);
    row("the same, stored in float", in_float, 2, 0);
    row("all that is seen", cases, 0, 0);
    for (const double slope : {0.0, 0.125, 0.25, 0.375, 0.5, 0.75, 1.0, 2.0, 4.0, 8.0})
        row("all that is seen", cases, 2, slope);
    return rows;
}

// The width of the half-lit strip on a floor under a roof's edge, from one end of the walk where all is lit to the
// other where nothing is.
template <class Lit> double width_of_penumbra(Lit lit) {
    int between = 0;
    const double step = 1e-3;
    for (double x = -2; x < 2; x += step) {
        const double share = lit(Vec<double>(x, 0, 0.005));
        between += share > 0 && share < 1;
    }
    return between * step;
}

// A lamp of the width 0.8 hangs 5 above the floor; the roof's edge is at several heights. A filter blurs all shadows
// alike, where the lamp's width makes them the softer, the higher the edge (claim C19).
inline std::vector<Row> measure_penumbras() {
    const double lamp_width = 0.8, lamp_height = 5;
    const LightView view({.eye = {0, lamp_height, 0}, .target = {0, 0, 0}, .up = {0, 0, 1}, .field_of_view = 60});
    std::vector<Row> rows;
    for (const float edge : {0.25f, 0.5f, 1.0f, 2.0f, 3.0f}) {
        const Scene<Box<>, Plane<>> scene({Box<>{{0, edge, -9}, {9, edge, 9}}}, {Plane<>{{0, 0, 0}, {0, 1, 0}}});
        const ShadowMap map(scene, view, 512);
        Row row = Row().set("edge_height", static_cast<double>(edge));
        row.set("lamp", lamp_width * edge / (lamp_height - edge));
        for (const int filter : {0, 4, 12})
            row.set("filter_" + std::to_string(filter), width_of_penumbra([&](const Vec<double> &place) {
                        return map.lit(place, {0, 1, 0}, {.filter = filter});
                    }));
        rows.push_back(row);
    }
    return rows;
}

} // namespace course
