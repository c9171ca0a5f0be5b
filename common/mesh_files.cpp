#include "common/mesh_files.hpp"

#include "common/errors.hpp"
#include "common/mesh_checks.hpp"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace course {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Points = std::vector<Point>;
using Faces = std::vector<std::vector<std::size_t>>;

std::string content_of(const std::filesystem::path &file) {
    const std::string name = file.string();
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        throw InputError(name, "no such file");
    if (std::filesystem::is_directory(status))
        throw InputError(name, "is a folder, not a mesh file");
    std::ifstream stream(file, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (!stream)
        throw InputError(name, "cannot be read");
    if (content.empty())
        throw InputError(name, "is empty");
    return content;
}

// What CGAL makes of the checked content; false where it refuses it. Its readers print nothing.
bool read_soup(const std::string &name, const std::string &ending, const std::string &content, Points &points,
               Faces &faces) {
    const auto quiet = CGAL::parameters::verbose(false);
    if (ending == ".obj") {
        std::istringstream stream(checked_obj(name, content));
        return CGAL::IO::read_OBJ(stream, points, faces, quiet);
    }
    if (ending == ".off") {
        std::istringstream stream(checked_off(name, content));
        return CGAL::IO::read_OFF(stream, points, faces, quiet);
    }
    if (ending == ".ply") {
        std::istringstream stream(checked_ply(name, content));
        return CGAL::IO::read_PLY(stream, points, faces, quiet);
    }
    if (ending == ".stl") {
        std::istringstream stream(checked_stl(name, content));
        return CGAL::IO::read_STL(stream, points, faces, quiet);
    }
    throw InputError(name, "its ending names no kind of mesh file (.obj, .off, .ply and .stl can be read)");
}

void add_point(const std::string &name, const Point &point, MeshFile &mesh) {
    const Vec<float> p(static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z()));
    mesh.points.push_back(p);
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
        throw InputError(name, "point " + std::to_string(mesh.points.size()) +
                                   " has a coordinate that is not finite in single precision");
}

// A polygon becomes the fan of triangles around its first corner.
void add_face(const std::string &name, const std::vector<std::size_t> &face, MeshFile &mesh) {
    if (face.size() < 3)
        throw InputError(name, "has a face with fewer than three corners");
    for (const std::size_t index : face)
        if (index >= mesh.points.size())
            throw InputError(name,
                             "a face names a point that is not there; there are " + std::to_string(mesh.points.size()));
    for (std::size_t i = 2; i < face.size(); ++i)
        mesh.triangles.push_back({static_cast<std::uint32_t>(face[0]), static_cast<std::uint32_t>(face[i - 1]),
                                  static_cast<std::uint32_t>(face[i])});
}

} // namespace

MeshFile read_mesh(const std::filesystem::path &file) {
    const std::string name = file.string(), content = content_of(file);
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    Points points;
    Faces faces;
    bool read = false;
    try {
        read = read_soup(name, ending, content, points, faces);
    } catch (const InputError &) {
        throw;
    } catch (const std::exception &) {
    }
    if (points.size() > 0 && faces.empty())
        throw InputError(name, "holds points but no face");
    if (!read)
        throw InputError(name, faces.empty() ? "holds no face" : "is not a well-formed " + ending.substr(1) + " file");

    MeshFile mesh;
    for (const Point &point : points)
        add_point(name, point, mesh);
    for (const auto &face : faces)
        add_face(name, face, mesh);
    if (mesh.triangles.empty())
        throw InputError(name, "holds no face");

    // A text that was cut off inside its list of faces may still be well-formed. It betrays itself: its last line does
    // not end, and there are points that no face names.
    std::vector<bool> used(mesh.points.size());
    for (const auto &triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            used[index] = true;
    if (ending == ".obj" && content.back() != '\n' && std::ranges::find(used, false) != used.end())
        throw InputError(name, "ends in the middle of a line, and faces are missing");
    return mesh;
}

} // namespace course
