// Lesson 08, step 8: a mesh out of a file, and what may be wrong with it. Compiled once (load.cpp): nearly every
// program that follows loads one.
#pragma once
#include "chapters/08_mesh/mesh.hpp"

#include <cstddef>
#include <filesystem>

namespace course {

// Triangles that are kept, so that ids stay what the file says, but that deserve a warning.
struct MeshFaults {
    std::size_t without_area = 0; // never hit
    std::size_t duplicates = 0;   // have the corners of an earlier one; the earlier one, with the lower id, is hit
};

MeshFaults count_faults(const Mesh<> &mesh);

// Reads the file, with normals at its points. Warns of faults on stderr; throws InputError naming the file.
Mesh<> load_mesh(const std::filesystem::path &file);

// The bunny that comes with Debian's and Ubuntu's package glmark2-data: 69,666 triangles, closed. Throws InputError
// that says how to get it.
std::filesystem::path find_bunny();

} // namespace course
