// H11 in corners: rays from inside a closed mesh meet it next to an edge or a corner and are spawned there. Seen from
// inside, edges are concave: the neighbouring face stands right beside the point, and no ray may start beyond it.
#include "chapters/03_light_and_shadow/spawn.hpp"
#include "chapters/08_mesh/mesh.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
#include "tests/hard_cases/suites.hpp"

#include <array>

namespace course::hard {
namespace {

// A body with eight corners, of which bit k of the number says on which side of axis k it lies. `closing`: how much
// narrower the side with bit 0 is, so that two long faces meet it at an angle; 1 makes an edge of it.
Mesh<> body(Random &random, double scale, const Vec<double> &centre, double thickness, double closing) {
    const Vec<double> w = unit_vector(random), u = across(random, w), v = cross(w, u);
    Mesh<> mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, z = corner & 4 ? 1 : -1;
        const double narrower = corner & 1 ? 1 - closing : 1;
        mesh.points.push_back(Vec<float>(centre + scale * (x * u + thickness * narrower * y * v + z * w)));
    }
    // Both triangles of each face, counter-clockwise from outside.
    mesh.indices = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

// Exactly: a ray from a point inside meets an odd number of triangles. A direction that meets an edge is not taken.
bool is_inside_exactly(Random &random, const Mesh<> &mesh, const Vec<double> &point) {
    while (true) {
        const Ray<double> ray{point, unit_vector(random)};
        int hits = 0, boundaries = 0;
        for (Id id = 0; id < size(mesh); ++id) {
            const auto verdict = exact::answer(ray, triangle(mesh, id)).verdict;
            hits += verdict == exact::Verdict::hit;
            boundaries += verdict == exact::Verdict::boundary;
        }
        if (boundaries == 0)
            return hits % 2 == 1;
    }
}

struct CornerCell {
    std::string test;
    double thickness, closing;
    bool at_corner; // else along an edge
    double off;     // how far from it, in sizes
};

// Where new rays start: as the course has it, or as a renderer has it whose points are floats.
enum class Start { by_bound, ulps_in_float };

// A place on a face, `off` away from an edge of it or (in two directions) from a corner.
Vec<double> place_beside(Random &random, const Mesh<> &mesh, double off, bool at_corner) {
    const std::uint32_t corner = random.bits() % 8, axis = random.bits() % 3, turn = 1 + random.bits() % 2;
    const auto neighbour = [&](std::uint32_t k) { return Vec<double>(mesh.points[corner ^ (1u << (k % 3))]); };
    const Vec<double> from(mesh.points[corner]), along = neighbour(axis) - from, aside = neighbour(axis + turn) - from;
    const double way = at_corner ? off * random.uniform(0.1, 1) : random.uniform(0.05, 0.95);
    return from + way * along + off * random.uniform(0.1, 1) * aside;
}

void spawn_in_corner(Random &random, const CornerCell &cell, double away, Start start, SpawnTally &tally) {
    const double scale = std::pow(10.0, static_cast<int>(random.bits() % 10) - 3);
    const Vec<double> centre = as_float(away * scale * unit_vector(random));
    const Mesh<> mesh = body(random, scale, centre, cell.thickness, cell.closing);
    Vec<double> eye(0);
    double sum = 0;
    for (const Vec<float> &point : mesh.points) { // a mean of the corners lies inside
        const double weight = random.uniform(0.5, 1);
        eye += weight * Vec<double>(point);
        sum += weight;
    }
    eye /= sum;
    const Ray<double> ray{eye, place_beside(random, mesh, cell.off, cell.at_corner) - eye};
    const auto hit = closest_hit(ray, mesh);
    ++tally.spawned;
    if (!hit) {
        ++tally.leaks;
        ++tally.wrong;
        return;
    }
    const auto found = surface(ray, hit.t, triangle(mesh, hit.id));
    const Vec<double> direction =
        normalize(across(random, found.normal)) - std::tan(random.uniform(0, 1.5)) * found.normal;
    Ray<double> spawned = spawn_ray(found, direction);
    const Vec<double> largest = abs(found.point);
    const double ulp = std::ldexp(1.0, std::ilogb(std::max({largest.x, largest.y, largest.z})) - 23);
    if (start == Start::ulps_in_float)
        spawned.origin = as_float(found.point - 8 * ulp * found.normal);
    tally.note_offset(std::abs(dot(spawned.origin - found.point, found.normal)) / ulp);
    ++tally.leaks_asked;
    const bool acne = exact::answer(spawned, triangle(mesh, hit.id)).verdict == exact::Verdict::hit;
    const bool leaked = !acne && (!is_inside_exactly(random, mesh, spawned.origin) || !closest_hit(spawned, mesh));
    tally.acne += acne;
    tally.leaks += leaked;
    tally.wrong += acne || leaked;
}

void corner_rows(const CornerCell &cell, double away, const Settings &settings, Outcome &outcome) {
    char parameter[96];
    std::snprintf(parameter, sizeof parameter, "%g sizes away, %g off %s", away, cell.off,
                  cell.at_corner ? "a corner" : "an edge");
    const std::uint64_t stream = stream_of(cell.test + parameter, settings.seed);
    const std::size_t cases = settings.cases / 10;
    for (const Start start : {Start::by_bound, Start::ulps_in_float}) {
        SpawnTally all;
        std::mutex adding;
        parallel_for((cases + batch_size - 1) / batch_size, [&](std::size_t chunk) {
            SpawnTally tally;
            for (std::size_t i = chunk * batch_size; i < std::min(cases, (chunk + 1) * batch_size); ++i) {
                Random random(stream, i);
                spawn_in_corner(random, cell, away, start, tally);
            }
            const std::lock_guard lock(adding);
            all.add(tally);
        });
        const bool is_default = start == Start::by_bound;
        close_spawn_row(outcome,
                        result_row("H11", cell.test, is_default ? "offset by a bound" : "8 ulp from the face",
                                   is_default, is_default ? "double" : "float", parameter, settings),
                        std::move(all), is_default);
    }
}

Outcome corners(const Settings &settings) {
    Outcome outcome;
    for (const double away : {2.0, 100.0})
        for (const bool at_corner : {false, true})
            for (const double off : {1e-3, 1e-6, 1e-9}) {
                corner_rows({"spawn in a box's corners", 0.7, 0, at_corner, off}, away, settings, outcome);
                corner_rows({"spawn in a wedge's corners", 0.02, 0.98, at_corner, off}, away, settings, outcome);
            }
    return outcome;
}

} // namespace

Suite corner_suite() { return {"spawned rays in corners", {"H11"}, corners}; }

} // namespace course::hard
