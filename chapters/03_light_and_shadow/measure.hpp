// Lesson 03, the experiments: acne and leaks against the offset and the scene's scale (claim C12), and the noise of a
// soft shadow against its samples.
#pragma once
#include "chapters/03_light_and_shadow/direct_light.hpp"
#include "common/plot.hpp"
#include "common/report.hpp"

#include <cstdio>
#include <string>

namespace course {

struct SpawnTally {
    int rays = 0, acne = 0, leaks = 0;
};

// A direction at a random angle below 90 degrees to the unit normal.
inline Vec<double> random_exit(const Vec<double> &normal, Random &random) {
    const Vec<double> any(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double cosine = 1 - random.uniform();
    return cosine * normal + std::sqrt(1 - cosine * cosine) * normalize(cross(normal, any));
}

// Rays meet a sphere of radius `size`, whose centre is two sizes from the origin, and leave it again. It is acne when a
// new ray meets the sphere, and a leak when it starts beyond a wall that stands size / 100 above the surface. A
// negative delta stands for spawn_ray().
inline SpawnTally tally_spawns(double size, double delta, int rays, std::uint64_t seed) {
    const Sphere<> sphere{Vec<float>(2 * size * Vec<double>(0.6, -0.64, 0.48)), static_cast<float>(size)};
    const Vec<double> centre(sphere.centre);
    Random random(seed);
    SpawnTally tally;
    const auto count = [&](const auto &ray, const auto &spawn_at) {
        const auto t = intersect(ray, sphere);
        if (!t)
            return;
        const auto at = surface(ray, *t, sphere);
        const auto spawned = spawn_at(*t)(at, random_exit(Vec<double>(at.normal), random), infinity<double>);
        ++tally.rays;
        tally.acne += any_hit(spawned, sphere);
        tally.leaks += length(Vec<double>(spawned.origin) - centre) > 1.01 * size;
    };
    while (tally.rays < rays) {
        const auto aim = [&] { return size * Vec<double>(random.uniform(-1, 1), random.uniform(-1, 1), 0); };
        const Vec<double> eye = centre + aim() + Vec<double>(0, 0, 4 * size), direction = centre + aim() - eye;
        const Ray<float> rounded{Vec<float>(eye), normalize(Vec<float>(direction))};
        if (delta < 0)
            count(Ray<double>{eye, direction}, [](double) { return ExactSpawn{}; });
        else
            count(rounded, [&](float t) { return ConstantOffset{rounded, t, static_cast<float>(delta)}; });
    }
    return tally;
}

inline std::vector<Row> measure_offsets(Plot &plot, std::uint64_t seed) {
    plot = {"Shadow rays that go wrong", "radius of the sphere", "acne and leaks per million", true, true, {}};
    std::vector<Row> rows;
    for (const double delta : {1e-5, 1e-4, 1e-3, 1e-2, -1.0}) {
        char name[32] = "spawn_ray()";
        if (delta > 0)
            std::snprintf(name, sizeof name, "δ = %g", delta);
        Series series{name, {}};
        for (int exponent = -4; exponent <= 6; ++exponent) {
            const double size = std::pow(10.0, exponent);
            const SpawnTally tally = tally_spawns(size, delta, 20000, seed);
            const double acne = 1e6 * tally.acne / tally.rays, leaks = 1e6 * tally.leaks / tally.rays;
            char radius[16];
            std::snprintf(radius, sizeof radius, "%g", size);
            rows.push_back(Row().set("start", name).set("radius", radius).set("acne_ppm", acne).set("leak_ppm", leaks));
            series.points.push_back({size, acne + leaks});
        }
        plot.series.push_back(series);
    }
    return rows;
}

// Under the edge of a roof, a row of places across the penumbra; each is lit many times over by as many samples, in
// strata or anywhere on the light. The error is the root of the mean square, as a share of the light without a roof.
inline std::vector<Row> measure_noise(Plot &plot, std::uint64_t seed) {
    const Scene roof(std::vector{Box<>{{0, 1, -50}, {50, 1, 50}}});
    const Plane<> floor{{0, 0, 0}, {0, 1, 0}};
    const Rectangle lamp{{-1, 5, -1}, {2, 0, 0}, {0, 0, 2}};
    const auto light_at = [&](double x, int strata, Random &random) {
        const Surface<double, Plane<>> surface{{x, 0, 0}, {0, 1, 0}, floor};
        const Lights lights(std::vector{AreaLight<Rectangle>{lamp, Colour(1), strata}});
        return static_cast<double>(direct_light(surface, {0, 1, 0}, Colour(1), roof, lights, random).r);
    };
    Random random(seed);
    const double unshadowed = light_at(-2, 100, random);
    plot = {"Noise of a soft shadow", "shadow rays for a point", "error, share of the full light", true, true, {}};
    plot.series = {{"anywhere on the light", {}}, {"one in each stratum", {}}};
    std::vector<Row> rows;
    for (const int strata : {1, 2, 4, 8, 16, 32}) {
        double squares[2] = {0, 0};
        int cases = 0;
        const int samples = strata * strata, repeats = 8192 / samples + 24;
        for (double x = -0.24; x < 0.25; x += 0.04) {
            const double exact = light_at(x, 400, random);
            for (int i = 0; i < repeats; ++i, ++cases) {
                double anywhere = 0;
                for (int k = 0; k < samples; ++k)
                    anywhere += light_at(x, 1, random) / samples;
                const double stratified = light_at(x, strata, random);
                squares[0] += (anywhere - exact) * (anywhere - exact);
                squares[1] += (stratified - exact) * (stratified - exact);
            }
        }
        Row row = Row().set("samples", samples);
        for (const int kind : {0, 1}) {
            const double error = std::sqrt(squares[kind] / cases) / unshadowed;
            row.set(kind ? "error_stratified" : "error_anywhere", error);
            plot.series[static_cast<std::size_t>(kind)].points.push_back({static_cast<double>(samples), error});
        }
        rows.push_back(row);
    }
    return rows;
}

} // namespace course
