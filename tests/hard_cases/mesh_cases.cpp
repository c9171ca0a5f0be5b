// Closed meshes: H6 a ray from inside must hit something, through every structure; H7 it must hit an odd number of
// triangles, and the right one first; H12 every structure answers as brute force does, bit for bit.
#include "chapters/08_mesh/inside.hpp"
#include "tests/hard_cases/closed_meshes.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
#include "tests/hard_cases/structures.hpp"
#include "tests/hard_cases/suites.hpp"
#include "tests/hard_cases/triangle_kernels.hpp"

#include <atomic>

namespace course::hard {
namespace {

// Counts over all cases, on every core: count(ray, stream) says how many of its answers are wrong.
template <class Count> std::uint64_t count_wrong(std::size_t cases, std::uint64_t stream, const ClosedMesh &closed,
                                                 std::size_t aim, const Count &count) {
    std::atomic<std::uint64_t> wrong{0};
    parallel_for((cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
        std::uint64_t found = 0;
        for (std::size_t i = chunk * batch_size; i < std::min(cases, (chunk + 1) * batch_size); ++i) {
            Random random(stream, i);
            found += count(ray_from_inside(random, closed, aim));
        }
        wrong += found;
    });
    return wrong;
}

// ---- H6 and H12 ----------------------------------------------------------------------------------------------------

Outcome leaks_and_agreement(const Settings &settings) {
    Outcome outcome;
    const auto meshes = closed_meshes();
    for (const ClosedMesh &closed : meshes) {
        const Scene scene(triangles(closed.mesh));
        for (const NamedStructure &structure : all_structures()) {
            const auto built = structure.around(triangles(closed.mesh));
            for (std::size_t aim = 0; aim < aims.size(); ++aim) {
                const std::string parameter = closed.name + ", " + aims[aim];
                const std::uint64_t stream = stream_of(parameter, settings.seed);
                // Along a needle a ray passes thousands of the grid's cells: a millisecond each, nine tenths of all
                // time.
                const std::size_t share = closed.needle_poles && structure.name == "grid" && aim > 0 ? 20 : 1;
                const std::size_t in_h6 = settings.cases / share;
                if (settings.wants("H6")) {
                    const auto leaks = count_wrong(in_h6, stream, closed, aim,
                                                   [&](const Ray<double> &ray) { return !built->closest(ray); });
                    close_row(outcome, result_row("H6", "mesh", structure.name, true, "double", parameter, settings),
                              in_h6, leaks, 0, true);
                }
                if (settings.wants("H12")) {
                    const std::size_t cases = (settings.quick ? settings.cases / 10 : settings.cases / 4) / share;
                    const auto differing = count_wrong(cases, stream, closed, aim, [&](const Ray<double> &ray) {
                        const auto one = built->closest(ray), other = closest_hit(ray, scene);
                        return one.t != other.t || one.id != other.id;
                    });
                    close_row(outcome, result_row("H12", "mesh", structure.name, true, "double", parameter, settings),
                              cases, differing, 0, true);
                }
                settings.done(1.0 / static_cast<double>(meshes.size() * aims.size() * all_structures().size()));
            }
        }
    }
    return outcome;
}

// ---- H7 ------------------------------------------------------------------------------------------------------------

struct CountedKernel {
    std::string name, scalar;
    bool is_default;
    std::function<std::uint32_t(const Ray<double> &, const Mesh<> &)> count;
};

std::vector<CountedKernel> counted_kernels() {
    const auto narrow = [](const Ray<double> &ray) {
        return Ray<float>{Vec<float>(ray.origin), Vec<float>(ray.direction)};
    };
    return {
        {"Moller-Trumbore as printed", "float", false,
         [=](const auto &ray, const auto &mesh) {
             return count_hits(narrow(ray), mesh,
                               [](const auto &r, const auto &flat) { return moller_trumbore_strict(r, flat); });
         }},
        {"Moller-Trumbore", "float", false,
         [=](const auto &ray, const auto &mesh) {
             return count_hits(narrow(ray), mesh,
                               [](const auto &r, const auto &flat) { return moller_trumbore(r, flat); });
         }},
        {"watertight", "float", true, [=](const auto &ray, const auto &mesh) { return count_hits(narrow(ray), mesh); }},
        {"watertight", "double", true, [](const auto &ray, const auto &mesh) { return count_hits(ray, mesh); }}};
}

Outcome parity(const Settings &settings) {
    Outcome outcome;
    const auto meshes = closed_meshes();
    for (const ClosedMesh &closed : meshes)
        for (std::size_t aim = 0; aim < aims.size(); ++aim) {
            const std::string parameter = closed.name + ", " + aims[aim];
            const std::uint64_t stream = stream_of(parameter, settings.seed);
            for (const CountedKernel &kernel : counted_kernels()) {
                const auto even = count_wrong(settings.cases, stream, closed, aim, [&](const Ray<double> &ray) {
                    return kernel.count(ray, closed.mesh) % 2 == 0;
                });
                close_row(
                    outcome,
                    result_row("H7", "mesh parity", kernel.name, kernel.is_default, kernel.scalar, parameter, settings),
                    settings.cases, even, 0, kernel.is_default);
            }
            const std::size_t cases = settings.cases / 10;
            for (const NamedStructure &structure : all_structures()) {
                const auto built = structure.around(triangles(closed.mesh));
                const std::size_t few = closed.needle_poles && structure.name == "grid" && aim > 0 ? cases / 20 : cases;
                const auto even = count_wrong(few, stream, closed, aim,
                                              [&](const Ray<double> &ray) { return built->count(ray) % 2 == 0; });
                close_row(
                    outcome,
                    result_row("H7", "mesh parity", "through " + structure.name, true, "double", parameter, settings),
                    few, even, 0, true);
            }
            const auto ids = count_wrong(cases, stream, closed, aim, [&](const Ray<double> &ray) {
                return wrong_nearest(ray, closed.mesh, closest_hit(ray, closed.mesh));
            });
            close_row(outcome, result_row("H7", "mesh id", "watertight", true, "double", parameter, settings), cases,
                      ids, wrong_ids_allowed(closed), true);
            settings.done(1.0 / static_cast<double>(meshes.size() * aims.size()));
        }
    return outcome;
}

} // namespace

Suite mesh_suite() { return {"mesh", {"H6", "H12"}, leaks_and_agreement, 16}; }
Suite parity_suite() { return {"mesh parity", {"H7"}, parity, 6}; }

} // namespace course::hard
