// Reading triangle meshes from OBJ, OFF, PLY and STL files (CGAL's polygon soup reader, in mesh_files.cpp alone).
#pragma once
#include "common/vectors.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace course {

struct MeshFile {
    std::vector<Vec<float>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; // indices of points; polygons are cut into fans
};

// Throws InputError naming the file: missing, of an unknown format, malformed, without a face, with a coordinate that
// is not finite in float or an index out of range.
MeshFile read_mesh(const std::filesystem::path &file);

} // namespace course
