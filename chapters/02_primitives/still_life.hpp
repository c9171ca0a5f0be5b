// Lesson 02, the picture: one of each primitive, arranged as one arranges plaster solids for a drawing lesson.
#pragma once
#include "chapters/01_ray_casting/scene.hpp"
#include "chapters/01_ray_casting/sphere.hpp"
#include "chapters/02_primitives/affine_triangle.hpp"
#include "chapters/02_primitives/cone.hpp"
#include "chapters/02_primitives/cylinder.hpp"
#include "chapters/02_primitives/disk.hpp"
#include "chapters/02_primitives/lattice_blob.hpp"
#include "chapters/02_primitives/torus.hpp"
#include "common/viewpoint.hpp"

#include <array>

namespace course {

using StillLife = Scene<Plane<>, Disk<>, AffineTriangle<>, Cylinder<>, Cone<>, Box<>, Sphere<>, Implicit<Torus<>>,
                        Implicit<LatticeBlob<>>>;

// The regular solid of twenty triangles: its corners are those of three golden rectangles that stand crosswise.
inline std::vector<AffineTriangle<>> icosahedron(const Vec<float> &centre, float radius) {
    const float golden = (1 + std::sqrt(5.0f)) / 2, scale = radius / std::sqrt(1 + golden * golden);
    std::array<Vec<float>, 12> corner;
    for (unsigned i = 0; i < 12; ++i) {
        const float one = i & 1 ? 1.0f : -1.0f, long_one = i & 2 ? golden : -golden;
        const unsigned axis = i / 4;
        Vec<float> p(0);
        p[static_cast<int>(axis)] = one;
        p[static_cast<int>((axis + 1) % 3)] = long_one;
        corner[i] = centre + scale * p;
    }

    // Three corners that are pairwise one edge apart are a face.
    const auto edge = [&](unsigned i, unsigned j) { return distance(corner[i], corner[j]) < 2.01f * scale; };
    std::vector<AffineTriangle<>> faces;
    for (unsigned i = 0; i < 12; ++i)
        for (unsigned j = i + 1; j < 12; ++j)
            for (unsigned k = j + 1; k < 12; ++k) {
                if (!edge(i, j) || !edge(j, k) || !edge(k, i))
                    continue;
                const Vec<float> a = corner[i], b = corner[j], c = corner[k];
                const bool outward = dot(cross(b - a, c - a), a - centre) > 0;
                faces.push_back(outward ? affine_triangle(a, b, c) : affine_triangle(a, c, b));
            }
    return faces;
}

inline StillLife still_life() {
    const Vec<float> up(0, 1, 0);
    return StillLife({{{0, 0, 0}, up}}, {{{0, 1.1f, 0}, up, 0.95f}, {{0.25f, 2.3f, -2.6f}, {-0.25f, 0.1f, 1}, 1.95f}},
                     icosahedron({1.2f, 0.6f, 1.75f}, 0.72f), {{{0, 0, 0}, {0, 1.1f, 0}, 0.95f}},
                     {{{-2.35f, 2.6f, -0.5f}, {-2.35f, 0, -0.5f}, 0.95f}}, {{{1.65f, 0, -1.3f}, {3.05f, 1.4f, 0.1f}}},
                     {{{2.35f, 2.05f, -0.6f}, 0.65f}}, {shape_of(Torus<>{{-1.15f, 0.27f, 1.75f}, up, 0.72f, 0.27f})},
                     {shape_of(LatticeBlob<>{{0, 1.98f, 0}, 0.61f, 1.12f})});
}

inline const Viewpoint still_life_view{.eye = {1.9, 3.9, 9.6}, .target = {0.1, 1.62, 0}, .field_of_view = 32};

} // namespace course
