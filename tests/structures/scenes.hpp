// The scenes and rays on which a structure must agree with brute force: small, and hard on purpose. Compiled once
// (scenes.cpp), for the tests of every structure.
#pragma once
#include "chapters/01_ray_casting/ray.hpp"
#include "chapters/08_mesh/triangle.hpp"
#include "common/random.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace course::structure_test {

using Mesh = std::vector<Triangle<>>;

struct TestMesh {
    std::string name;
    Mesh triangles;
    std::vector<Vec<double>> inside; // points inside, for a closed mesh
};

inline Vec<float> random_point(Random &random, double size = 1) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Triangles anywhere, of one size.
Mesh soup(std::size_t count, double size, std::uint64_t seed);

// Long and thin, in all directions, through each other's boxes.
Mesh needles(std::size_t count, std::uint64_t seed);

// The skin of unit cubes on a lattice: every box face, cell border and centroid falls on the same few numbers.
TestMesh voxels(int side, std::uint64_t seed);

// A closed sphere of many slices: needles that meet in two poles.
TestMesh sliced_sphere(int around, int along, const Vec<double> &centre, double radius, std::string name);

Mesh scaled(Mesh mesh, float scale, const Vec<float> &shift = Vec<float>(0));

std::vector<TestMesh> hard_meshes();

// Rays at the mesh: from around and from inside, at random, at corners, at edges, along the axes through corners, in
// the planes of triangles, from surfaces, as fast along two axes, with zero and nearly zero components, and with
// limited intervals. So many kinds take turns.
inline constexpr std::size_t kinds_of_hard_rays = 9;
std::vector<Ray<double>> hard_rays(const Mesh &mesh, std::size_t count, std::uint64_t seed);

} // namespace course::structure_test
