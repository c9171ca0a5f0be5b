// Closed meshes and rays from inside them, on which H6, H7 and H12 rest.
#pragma once
#include "chapters/08_mesh/ball.hpp"
#include "chapters/08_mesh/mesh.hpp"
#include "tests/hard_cases/aim.hpp"
#include "tests/oracle/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace course::hard {

struct ClosedMesh {
    std::string name;
    Mesh<> mesh;
    Vec<double> inside; // from any place within `room` of it, every ray leaves
    double room;
    Vec<double> size; // half of the mesh's extent
    bool needle_poles = false;

    // Surely not outside: within a ball (or the ball that a mesh is, stretched) that the mesh has room for.
    bool holds(const Vec<double> &place) const { return length((place - inside) / size) < 0.71; }
};

inline ClosedMesh moved(const std::string &name, const Vec<double> &scale, const Vec<double> &to,
                        bool needles = false) {
    Mesh<> mesh = ball(2);
    for (Vec<float> &point : mesh.points)
        point = Vec<float>(Vec<double>(point) * scale + to);
    return {name, mesh, to, 0.2 * std::min({scale.x, scale.y, scale.z}), scale, needles};
}

// A box whose sides are cut along whole numbers, two triangles a square: rays along the axes meet edges and corners.
inline ClosedMesh lattice() {
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
    return {"lattice", mesh, {2, 2, 2}, 1.9, {2, 2, 2}};
}

inline std::vector<ClosedMesh> closed_meshes() {
    return {moved("ball", Vec<double>(1), {0, 0, 0}), moved("needles 1e4 long", {1, 1, 1e4}, {0, 0, 0}, true),
            moved("ball at (148376, 1234, -223423)", Vec<double>(1), {148376, 1234, -223423}),
            moved("ball of radius 1e-3", Vec<double>(1e-3), {0, 0, 0}), lattice()};
}

inline const std::vector<std::string> aims{"anywhere", "at edges", "at corners", "along an axis through a corner"};

inline Ray<double> ray_from_inside(Random &random, const ClosedMesh &closed, std::size_t aim) {
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
        do { // another corner, until the place level with the middle is inside
            eye = Vec<double>(triangle(closed.mesh, random.bits() % size(closed.mesh)).a);
            eye[axis] = closed.inside[axis];
        } while (!closed.holds(eye));
        eye[axis] = as_float(closed.inside[axis] + random.uniform(-closed.room, closed.room));
        return {eye, direction};
    }
    }
}

// Whether the oracle contradicts a nearest hit: it misses that triangle, or surely hits another one before it.
inline bool wrong_nearest(const Ray<double> &ray, const Mesh<> &mesh, const Hit<double> &hit) {
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

// How many nearest triangles of a million may be wrong: at the poles of needles corners lie closer than rounding.
inline double wrong_ids_allowed(const ClosedMesh &closed) { return closed.needle_poles ? 10 : 0; }

} // namespace course::hard
