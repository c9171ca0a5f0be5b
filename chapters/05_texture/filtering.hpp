// Lesson 05, the experiment: how many samples a textured picture needs, and how many texels a texture.
#pragma once
#include "chapters/05_texture/antialias.hpp"
#include "chapters/05_texture/paint.hpp"
#include "common/image_difference.hpp"
#include "common/output_files.hpp"
#include "common/plot.hpp"
#include "common/program.hpp"
#include "common/report.hpp"

#include <cstdio>

namespace course {

// The mean of samples squared random places in every pixel: what stratification improves on.
template <class ColourAtPlace> TileFunction randomly_sampled(int samples, ColourAtPlace colour_at_place) {
    return [=](const Tile &tile, Picture &picture) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                Random random(7, static_cast<std::uint64_t>(y * picture.width + x));
                Colour sum(0);
                for (int i = 0; i < samples * samples; ++i)
                    sum += stratified_mean(x, y, 1, random, colour_at_place, [](const Colour &) {});
                picture(x, y) = sum / static_cast<float>(samples * samples);
            }
    };
}

// A row of the table and a point of the plot: how far the tile function's picture is from the reference.
inline Row error_row(const TileFunction &fill, const Picture &reference, Series &by_rays, Series &by_time) {
    const RenderedPicture done = render_picture(by_rays.name, reference.width, reference.height, fill);
    const double pixels = static_cast<double>(reference.pixels.size());
    const double rays = static_cast<double>(done.rays) / pixels, error = difference(done.picture, reference).rmse_steps;
    by_rays.points.push_back({rays, error});
    by_time.points.push_back({done.seconds, error});
    return Row()
        .set("method", by_rays.name)
        .set("rays per pixel", rays)
        .set("seconds", done.seconds)
        .set("error (1/255)", error);
}

// Random, stratified and adaptive sampling against 324 stratified samples.
template <class ColourAtPlace>
void measure_samples(Program &program, const ColourAtPlace &colour_at_place, Picture reference) {
    const Sampling most{.first = 18, .refined = 1, .seed = 99};
    reference =
        render_picture("reference", reference.width, reference.height, antialiased(most, colour_at_place)).picture;
    Report report{"Sampling a textured picture", Row().set("reference samples", most.first * most.first), {}};
    const std::vector<Series> methods{{"random", {}}, {"stratified", {}}, {"adaptive", {}}};
    Plot rays{report.title, "rays per pixel, shadow rays included", "RMSE in steps of 1/255", true, true, methods};
    Plot time{report.title, "seconds", "RMSE in steps of 1/255", true, true, methods};
    const auto measure = [&](std::size_t method, const TileFunction &fill) {
        report.results.push_back(error_row(fill, reference, rays.series[method], time.series[method]));
    };
    for (const int samples : {1, 2, 3, 4, 6, 8})
        measure(0, randomly_sampled(samples, colour_at_place));
    for (const int samples : {1, 2, 3, 4, 6, 8})
        measure(1, antialiased({samples, 1}, colour_at_place));
    for (const int refined : {3, 4, 6, 8})
        measure(2, antialiased({2, refined}, colour_at_place));
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("samples.json"), report);
    write_plot(program.beside_picture("samples.svg"), rays);
    write_plot(program.beside_picture("samples_time.svg"), time);
}

// A smooth pattern stored in more and more texels, looked up by the nearest and by the four nearest.
inline void measure_texels(Program &program) {
    const auto waves = [](const Uv &at) {
        return Colour(static_cast<float>(0.5 + 0.5 * std::sin(12 * pi * at.x) * std::sin(12 * pi * at.y)));
    };
    Report report{"Looking up a texture", {}, {}};
    Plot plot{report.title, "texels a side", "RMSE in steps of 1/255", true, true, {{"nearest", {}}, {"bilinear", {}}}};
    for (int texels = 16; texels <= 1024; texels *= 2) {
        const ImageTexture texture(paint(texels, texels, waves), Border::repeat);
        Random random(program.seed);
        double nearest = 0, bilinear = 0;
        constexpr int places = 20000;
        for (int i = 0; i < places; ++i) {
            const Uv at{random.uniform(), random.uniform()};
            const double exact = static_cast<double>(waves(at).r);
            nearest += std::pow(static_cast<double>(nearest_texel(texture, at).r) - exact, 2) / places;
            bilinear += std::pow(static_cast<double>(colour_at(texture, at).r) - exact, 2) / places;
        }
        nearest = 255 * std::sqrt(nearest), bilinear = 255 * std::sqrt(bilinear);
        report.results.push_back(
            Row().set("texels a side", texels).set("nearest (1/255)", nearest).set("bilinear (1/255)", bilinear));
        plot.series[0].points.push_back({static_cast<double>(texels), nearest});
        plot.series[1].points.push_back({static_cast<double>(texels), bilinear});
    }
    std::printf("%s\n", terminal_table(report.results).c_str());
    write_json(program.beside_picture("texels.json"), report);
    write_plot(program.beside_picture("texels.svg"), plot);
}

} // namespace course
