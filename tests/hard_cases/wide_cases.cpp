// The wide BVH in every mode: H6 nothing leaks, H7 the nearest triangle is the oracle's, H12 every answer is brute
// force's, bit for bit.
#include "chapters/15_wide_bvh/batch.hpp"
#include "tests/hard_cases/closed_meshes.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
#include "tests/hard_cases/suites.hpp"

#include <atomic>
#include <bit>
#include <functional>
#include <memory>

namespace course::hard {
namespace {

using Hits = std::vector<Hit<double>>;

struct Mode {
    std::string name;
    std::function<Hits(const std::vector<Ray<double>> &)> trace;
};

template <WideOptions Options> void add_modes(std::vector<Mode> &modes, const std::string &name, const Mesh<> &mesh) {
    const auto list = triangles(mesh);
    const auto bvh = std::make_shared<WideBvhBy<Triangle<>, Options>>(std::span<const Triangle<>>(list));
    const auto add = [&](const std::string &way_name, Way way) {
        modes.push_back({name + way_name, [=](const std::vector<Ray<double>> &rays) {
                             Hits hits(rays.size());
                             trace(way, course::Batch(rays), false, *bvh,
                                   [&](std::size_t i, const Hit<double> &hit) { hits[i] = hit; });
                             return hits;
                         }});
    };
    add("", Way::one_by_one);
    if constexpr (is_packed<Triangle<>, Options>) {
        add(", packets", Way::packets);
        add(", in flight", Way::in_flight);
    }
}

std::vector<Mode> all_modes(const Mesh<> &mesh) {
    std::vector<Mode> modes;
    add_modes<WideOptions{}>(modes, "wide", mesh);
    add_modes<WideOptions{.leaf = WideOptions::Leaf::compact}>(modes, "wide, compact leaves", mesh);
    add_modes<WideOptions{
        .order = WideOptions::Order::distance, .two_nodes = false, .one_hit_path = true, .quick_t = false}>(
        modes, "wide, by distance", mesh);
    return modes;
}

struct Wrong {
    std::atomic<std::uint64_t> leaks{0}, ids{0}, differences{0};
};

// A batch of rays through every mode. Of the answers, some are held against the oracle and some against brute force.
void judge(const std::vector<Ray<double>> &rays, const ClosedMesh &closed, const std::vector<Mode> &modes,
           const Settings &settings, std::size_t held, std::vector<Wrong> &wrong) {
    Hits expected;
    if (settings.wants("H12"))
        for (std::size_t i = 0; i < held; ++i)
            expected.push_back(closest_hit(rays[i], closed.mesh));
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const Hits hits = modes[k].trace(rays);
        for (const Hit<double> &hit : hits)
            wrong[k].leaks += !hit;
        for (std::size_t i = 0; i < held; ++i) {
            if (settings.wants("H7"))
                wrong[k].ids += wrong_nearest(rays[i], closed.mesh, hits[i]);
            if (settings.wants("H12"))
                wrong[k].differences += hits[i].id != expected[i].id || std::bit_cast<std::uint64_t>(hits[i].t) !=
                                                                            std::bit_cast<std::uint64_t>(expected[i].t);
        }
    }
}

Outcome every_mode(const Settings &settings) {
    Outcome outcome;
    const auto meshes = closed_meshes();
    for (const ClosedMesh &closed : meshes) {
        const auto modes = all_modes(closed.mesh);
        for (std::size_t aim = 0; aim < aims.size(); ++aim) {
            const std::string parameter = closed.name + ", " + aims[aim];
            const std::uint64_t stream = stream_of("wide" + parameter, settings.seed);
            std::vector<Wrong> wrong(modes.size());
            const std::size_t batches = (settings.cases + batch_size - 1) / batch_size, held = batch_size / 20;
            parallel_for(batches, [&](std::size_t batch) {
                std::vector<Ray<double>> rays;
                for (std::size_t i = 0; i < batch_size; ++i) {
                    Random random(stream, batch * batch_size + i);
                    rays.push_back(ray_from_inside(random, closed, aim));
                }
                judge(rays, closed, modes, settings, held, wrong);
            });
            const auto close = [&](const std::string &family, const std::string &test, const std::string &mode,
                                   std::size_t cases, std::uint64_t found, double allowed) {
                if (settings.wants(family))
                    close_row(outcome, result_row(family, test, mode, true, "double", parameter, settings), cases,
                              found, allowed, true);
            };
            for (std::size_t k = 0; k < modes.size(); ++k) {
                close("H6", "mesh, wide modes", modes[k].name, batches * batch_size, wrong[k].leaks, 0);
                close("H7", "mesh id, wide modes", modes[k].name, batches * held, wrong[k].ids,
                      wrong_ids_allowed(closed));
                close("H12", "mesh, wide modes", modes[k].name, batches * held, wrong[k].differences, 0);
            }
            settings.done(1.0 / static_cast<double>(meshes.size() * aims.size()));
        }
    }
    return outcome;
}

} // namespace

Suite wide_suite() { return {"wide modes", {"H6", "H7", "H12"}, every_mode, 6}; }

} // namespace course::hard
