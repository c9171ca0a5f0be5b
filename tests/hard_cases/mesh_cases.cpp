// Closed meshes: H6 a ray from inside must hit something, through every structure; H7 it must hit an odd number of
// triangles, and the right one first; H12 every structure answers as brute force does, bit for bit.
#include "chapters/08_mesh/ball.hpp"
#include "chapters/08_mesh/inside.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/hard_cases/measure.hpp"
#include "tests/hard_cases/rows.hpp"
#include "tests/hard_cases/structures.hpp"
#include "tests/hard_cases/suites.hpp"
#include "tests/hard_cases/triangle_kernels.hpp"

#include <atomic>

namespace course::hard {
namespace {

struct ClosedMesh {
    std::string name;
    Mesh<> mesh;
    Vec<double> inside; // from any place within `room` of it, every ray leaves
    double room;
    bool needle_poles = false;
};

ClosedMesh moved(const std::string &name, const Vec<double> &scale, const Vec<double> &to, bool needles = false) {
    Mesh<> mesh = ball(2);
    for (Vec<float> &point : mesh.points)
        point = Vec<float>(Vec<double>(point) * scale + to);
    return {name, mesh, to, 0.2 * std::min({scale.x, scale.y, scale.z}), needles};
}

// A box whose sides are cut along whole numbers, two triangles a square: rays along the axes meet edges and corners.
ClosedMesh lattice() {
    constexpr int n = 4;
    Mesh<> mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int u, int v) {
                        Vec<float> p;
                        p[axis] = static_cast<float>(side);
                        p[(axis + 1) % 3] = static_cast<float>(u);
                        p[(axis + 2) % 3] = static_cast<float>(v);
                        return p;
                    };
                    const auto first = static_cast<std::uint32_t>(mesh.points.size());
                    for (const auto &p : {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)})
                        mesh.points.push_back(p);
                    if (side == 0)
                        mesh.indices.insert(mesh.indices.end(),
                                            {{first, first + 2, first + 1}, {first, first + 3, first + 2}});
                    else
                        mesh.indices.insert(mesh.indices.end(),
                                            {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
                }
    return {"lattice", mesh, {2, 2, 2}, 1.9};
}

std::vector<ClosedMesh> closed_meshes() {
    return {moved("ball", Vec<double>(1), {0, 0, 0}), moved("needles 1e4 long", {1, 1, 1e4}, {0, 0, 0}, true),
            moved("ball at (148376, 1234, -223423)", Vec<double>(1), {148376, 1234, -223423}),
            moved("ball of radius 1e-3", Vec<double>(1e-3), {0, 0, 0}), lattice()};
}

const std::vector<std::string> aims{"anywhere", "at edges", "at corners", "along an axis through a corner"};

Ray<double> ray_from_inside(Random &random, const ClosedMesh &closed, std::size_t aim) {
    Vec<double> eye = closed.inside + in_cube(random, closed.room);
    if (closed.name == "lattice" && random.bits() % 2)
        eye = closed.inside; // then the way to a corner is exact
    eye = as_float(eye);
    const Triangle<> target = triangle(closed.mesh, random.bits() % size(closed.mesh));
    const Vec<double> a(target.a), b(target.b);
    switch (aim) {
    case 0:
        return {eye, as_float(unit_vector(random))};
    case 1:
        return {eye, as_float(a + random.uniform() * (b - a) - eye)};
    case 2:
        return {eye, as_float(a - eye)};
    default: {
        const int axis = static_cast<int>(random.bits() % 3);
        Vec<double> direction(0);
        direction[axis] = either_sign(random);
        eye = a;
        eye[axis] = as_float(closed.inside[axis]);
        // Only if the place beside the middle is inside: that is sure where the corner is near the axis.
        const Vec<double> off = eye - closed.inside;
        if (closed.name != "lattice" && std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) > closed.room)
            return {as_float(closed.inside), as_float(direction)};
        if (closed.name == "lattice" && (eye != min(max(eye, Vec<double>(1)), Vec<double>(3))))
            return {closed.inside, direction};
        return {eye, direction};
    }
    }
}

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
        for_each_structure([&](const auto &structure) {
            const auto accelerated = structure.around(scene);
            for (std::size_t aim = 0; aim < aims.size(); ++aim) {
                const std::string parameter = closed.name + ", " + aims[aim];
                const std::uint64_t stream = stream_of(parameter, settings.seed);
                // Along a needle a ray passes thousands of the grid's cells: a millisecond each, nine tenths of all
                // time.
                const std::size_t share = closed.needle_poles && structure.name == "grid" && aim > 0 ? 20 : 1;
                const std::size_t in_h6 = settings.cases / share;
                if (settings.wants("H6")) {
                    const auto leaks = count_wrong(in_h6, stream, closed, aim, [&](const Ray<double> &ray) {
                        return !closest_hit(ray, accelerated);
                    });
                    close_row(outcome, result_row("H6", "mesh", structure.name, true, "double", parameter, settings),
                              in_h6, leaks, 0, true);
                }
                if (settings.wants("H12")) {
                    const std::size_t cases = (settings.quick ? settings.cases / 10 : settings.cases / 4) / share;
                    const auto differing = count_wrong(cases, stream, closed, aim, [&](const Ray<double> &ray) {
                        const auto one = closest_hit(ray, accelerated), other = closest_hit(ray, scene);
                        return one.t != other.t || one.id != other.id;
                    });
                    close_row(outcome, result_row("H12", "mesh", structure.name, true, "double", parameter, settings),
                              cases, differing, 0, true);
                }
                settings.done(1.0 / static_cast<double>(meshes.size() * aims.size() * structure_count));
            }
        });
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

// Whether the oracle contradicts the nearest hit: it misses that triangle, or surely hits another one before it.
bool wrong_id(const Ray<double> &ray, const Mesh<> &mesh) {
    const auto hit = closest_hit(ray, mesh);
    if (!hit)
        return true;
    const auto mine = exact::answer(ray, triangle(mesh, hit.id));
    if (!mine.may_hit())
        return true;
    for (Id id = 0; id < size(mesh); ++id)
        if (const auto other = exact::answer(ray, triangle(mesh, id));
            !other.may_miss() && other.t < mine.t * (1 - 0x1p-40))
            return true;
    return false;
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
            const std::size_t cases = settings.quick ? settings.cases / 10 : settings.cases / 10;
            const auto ids = count_wrong(cases, stream, closed, aim,
                                         [&](const Ray<double> &ray) { return wrong_id(ray, closed.mesh); });
            close_row(outcome, result_row("H7", "mesh id", "watertight", true, "double", parameter, settings), cases,
                      ids, closed.needle_poles ? 10 : 0, true);
            settings.done(1.0 / static_cast<double>(meshes.size() * aims.size()));
        }
    return outcome;
}

} // namespace

Suite mesh_suite() { return {"mesh", {"H6", "H12"}, leaks_and_agreement, 16}; }
Suite parity_suite() { return {"mesh parity", {"H7"}, parity, 6}; }

} // namespace course::hard
