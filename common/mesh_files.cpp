#include "common/mesh_files.hpp"

#include "common/errors.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <cmath>
#include <string>

namespace course {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

Vec<float> as_float(const Point &point) {
    return {static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z())};
}

bool is_finite(const Vec<float> &p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

} // namespace

MeshFile read_mesh(const std::filesystem::path &file) {
    const std::string name = file.string();
    if (!std::filesystem::is_regular_file(file))
        throw InputError(name, "no such file");
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
    bool read = false;
    try {
        read = CGAL::IO::read_polygon_soup(name, points, faces, CGAL::parameters::verbose(false));
    } catch (const std::exception &) {
    }
    if (!read)
        throw InputError(name, "not a mesh that can be read (OBJ, OFF, PLY and STL are)");

    MeshFile mesh;
    for (const Point &point : points) {
        mesh.points.push_back(as_float(point));
        if (!is_finite(mesh.points.back()))
            throw InputError(name, "point " + std::to_string(mesh.points.size()) + " is not finite");
    }
    for (const auto &face : faces) {
        for (const std::size_t index : face)
            if (index >= points.size())
                throw InputError(name, "a face names point " + std::to_string(index + 1) + " of " +
                                           std::to_string(points.size()));
        for (std::size_t i = 2; i < face.size(); ++i)
            mesh.triangles.push_back({static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[i - 1]),
                                      static_cast<std::uint32_t>(face[i])});
    }
    if (mesh.triangles.empty())
        throw InputError(name, "holds no face");
    return mesh;
}

} // namespace course
