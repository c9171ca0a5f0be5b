#include "chapters/08_mesh/load.hpp"
#include "chapters/08_mesh/normals.hpp"
#include "common/errors.hpp"
#include "common/mesh_files.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace course {

MeshFaults count_faults(const Mesh<> &mesh) {
    MeshFaults faults;
    std::vector<std::array<float, 9>> corners;
    for (Id id = 0; id < size(mesh); ++id) {
        const Triangle<> flat = triangle(mesh, id);
        faults.without_area += area_vector(flat) == Vec<double>(0);
        std::array sorted{std::array{flat.a.x, flat.a.y, flat.a.z}, std::array{flat.b.x, flat.b.y, flat.b.z},
                          std::array{flat.c.x, flat.c.y, flat.c.z}};
        std::ranges::sort(sorted);
        auto &[p, q, r] = sorted;
        corners.push_back({p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]});
    }
    std::ranges::sort(corners);
    faults.duplicates =
        corners.size() - static_cast<std::size_t>(std::ranges::unique(corners).begin() - corners.begin());
    return faults;
}

Mesh<> load_mesh(const std::filesystem::path &file) {
    MeshFile read = read_mesh(file);
    Mesh<> mesh{std::move(read.points), std::move(read.triangles)};
    const MeshFaults faults = count_faults(mesh);
    if (faults.without_area)
        std::fprintf(stderr, "%s: warning: %zu of %u triangles have no area and are never hit\n", file.c_str(),
                     faults.without_area, size(mesh));
    if (faults.duplicates)
        std::fprintf(stderr, "%s: warning: %zu of %u triangles repeat an earlier one\n", file.c_str(),
                     faults.duplicates, size(mesh));
    mesh.normals = normals_by_angle(mesh);
    return mesh;
}

std::filesystem::path find_bunny() {
    const char *set = std::getenv("XDG_DATA_DIRS");
    std::istringstream folders(std::string(set ? set : "") + ":/usr/local/share:/usr/share");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const auto file = std::filesystem::path(folder) / "glmark2/models/bunny.obj";
        if (std::error_code error; !folder.empty() && std::filesystem::is_regular_file(file, error))
            return file;
    }
    throw InputError("bunny.obj", "not found; install the package glmark2-data, or name a mesh with --mesh FILE");
}

} // namespace course
