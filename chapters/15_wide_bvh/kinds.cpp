#include "chapters/15_wide_bvh/kinds.hpp"

#include "chapters/15_wide_bvh/bounced.hpp"
#include "chapters/15_wide_bvh/by_kind.hpp"
#include "common/parallel.hpp"
#include "common/publish.hpp"
#include "common/timing.hpp"

namespace course {
namespace {

constexpr int side = 320;
constexpr int samples = 2; // squared
constexpr int rounds = 5;

using Rays = std::vector<Ray<double>>;

// The rays of each kind as they come, a batch for each round of each tile.
template <class AnyScene, class ColourOf>
std::array<std::vector<Rays>, ray_kinds> batches_of(const AnyScene &scene, const ColourOf &colour) {
    std::array<std::vector<Rays>, ray_kinds> batches;
    Picture picture(side, side);
    for (const Tile &tile : tiles_of(side, side))
        fill_tile(tile, picture, samples * samples, scene, colour, [&](RayKind kind, Batch rays) {
            if (!rays.empty())
                batches[kind].emplace_back(rays.begin(), rays.end());
            return hits_of(Way::one_by_one, rays, wants_any(kind), scene);
        });
    return batches;
}

// Nanoseconds a ray, for each way.
template <class AnyScene> Row times_of(RayKind kind, const std::vector<Rays> &batches, const AnyScene &scene) {
    std::vector<std::function<void()>> variants;
    for (const Way way : all_ways)
        variants.push_back([&, way] {
            for (const Rays &rays : batches)
                keep(hits_of(way, rays, wants_any(kind), scene));
        });
    std::size_t count = 0;
    for (const Rays &rays : batches)
        count += rays.size();
    const std::vector<double> seconds = median_seconds(variants, rounds);
    Row row = Row().set("rays", std::array{"camera", "shadow", "bounce", "shadow of bounce"}[kind]).set("count", count);
    for (std::size_t i = 0; i < all_ways.size(); ++i)
        row.set(std::array{"one_ns", "packets_ns", "in_flight_ns"}[i], 1e9 * seconds[i] / static_cast<double>(count));
    return row;
}

Picture filled(const TileFunction &fill) {
    Picture picture(side, side);
    const auto tiles = tiles_of(side, side);
    parallel_for(tiles.size(), [&](std::size_t i) { fill(tiles[i], picture); });
    return picture;
}

std::size_t pixels_that_differ(const Picture &a, const Picture &b) {
    std::size_t count = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            count += a(x, y) != b(x, y);
    return count;
}

} // namespace

void measure_kinds(const Program &program, const Studio &studio) {
    const auto scene = exhibit<WideBvh>(studio);
    const auto colour = bounced_exhibit(studio, Camera(studio.view, side, side), samples, program.seed);
    const unsigned cores = use_threads(0);
    use_threads(1);

    Report report{"Which way suits which kind of rays (one core, nanoseconds a ray)",
                  Row()
                      .set("seed", program.seed)
                      .set("triangles", size(studio.mesh()))
                      .set("samples", side * side * samples * samples),
                  {}};
    Plot plot{.title = "Rays of a tile",
              .x_label = "kind: camera, shadow, bounce, shadow of bounce",
              .y_label = "nanoseconds a ray",
              .series = {{"one by one", {}}, {"in packets", {}}, {"in flight", {}}}};
    const auto batches = batches_of(scene, colour);
    for (const RayKind kind : {camera_rays, shadow_rays, bounce_rays, far_shadow_rays}) {
        const Row &row = report.results.emplace_back(times_of(kind, batches[kind], scene));
        for (std::size_t i = 0; i < all_ways.size(); ++i)
            plot.series[i].points.push_back({static_cast<double>(kind), std::get<double>(row.values()[2 + i].second)});
    }
    publish(program, "kinds", report, plot);

    const TileFunction plain = each_pixel_ray_by_ray(scene, samples * samples, colour);
    const TileFunction ways[] = {plain, each_pixel_by_kind(scene, samples * samples, one_by_one, colour),
                                 each_pixel_by_kind(scene, samples * samples, by_kind, colour)};
    std::vector<Row> pictures;
    std::array<double, 3> alone{};
    for (unsigned threads = 1; threads <= cores; threads *= 2) {
        use_threads(threads);
        std::vector<std::function<void()>> variants;
        for (const TileFunction &fill : ways)
            variants.push_back([&] { keep(filled(fill)); });
        const std::vector<double> seconds = median_seconds(variants, rounds);
        Row row = Row().set("cores", threads);
        for (std::size_t i = 0; i < seconds.size(); ++i) {
            alone[i] = threads == 1 ? seconds[i] : alone[i];
            const std::string name = std::array{"ray by ray", "collected", "by kind"}[i];
            row.set(name + ", ms", 1e3 * seconds[i]).set(name + ", speed-up", alone[i] / seconds[i]);
        }
        pictures.push_back(row);
    }
    const std::size_t differing = pixels_that_differ(filled(plain), filled(ways[2]));
    std::printf(
        "The picture, ray by ray, with its rays collected, and each kind in its own way; %zu pixels differ\n%s\n",
        differing, terminal_table(pictures).c_str());
    use_threads(0);
}

} // namespace course
