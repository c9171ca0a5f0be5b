// Lesson 17, step 10: the mesh on its table as a rasteriser has it: points, and which three are a triangle.
#pragma once
#include "chapters/08_mesh/studio.hpp"
#include "chapters/17_gpu/screen_matrix.hpp"
#include "chapters/17_gpu/texels.hpp"

#include <array>

namespace course {

class RasterMesh {
  public:
    RasterMesh(const Gl &gl, const Studio &studio)
        : gl_(gl), vertices_(make_vertex_array(gl)), indices_(make_buffer(gl)), buffers_(gl) {
        // A point that several triangles share is put in its place once.
        const Mesh<> &mesh = studio.mesh();
        std::vector<std::array<std::uint32_t, 3>> indices = mesh.indices;
        std::vector<glm::vec4> corners, normals, lights;
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            corners.emplace_back(mesh.points[i], 0);
            normals.emplace_back(mesh.normals.empty() ? Vec<float>(0) : mesh.normals[i], 0);
        }
        // The table is the two last triangles, a square around it.
        const Disk<> &table = std::get<1>(studio.scene.shapes).front().shape;
        const auto first = static_cast<std::uint32_t>(corners.size());
        for (const auto &[x, z] : {std::pair{-1.0f, -1.0f}, {-1.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, -1.0f}})
            corners.emplace_back(table.centre + table.radius * Vec<float>(x, 0, z), 0);
        normals.insert(normals.end(), 4, glm::vec4(table.normal, 0));
        indices.push_back({first, first + 1, first + 2});
        indices.push_back({first, first + 2, first + 3});
        count_ = static_cast<GLsizei>(3 * indices.size());
        gl.BindVertexArray(vertices_);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof indices[0]),
                      indices.data(), GL_STATIC_DRAW);
        for (const PointLight &lamp : std::get<0>(studio.lights.kinds))
            lights.insert(lights.end(), {{Vec<float>(lamp.position), 0}, {lamp.intensity, 0}});
        buffers_.add("corners", GL_RGBA32F, corners);
        buffers_.add("normals", GL_RGBA32F, normals);
        buffers_.add("lamps", GL_RGBA32F, lights);
    }

    const TexelUnits &buffers() const { return buffers_; }
    int mesh_triangles() const { return count_ / 3 - 2; }

    void draw() const {
        gl_.BindVertexArray(vertices_);
        gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    }

  private:
    const Gl &gl_;
    GlName vertices_, indices_;
    TexelUnits buffers_;
    GLsizei count_ = 0;
};

// What a lamp sees: it looks at the table's middle, and sees all of it.
inline glm::mat4 lamp_matrix(const Studio &studio, const PointLight &lamp, int resolution) {
    const Disk<> &table = std::get<1>(studio.scene.shapes).front().shape;
    const Vec<double> middle(table.centre);
    const double distance = length(middle - lamp.position), reach = 1.05 * static_cast<double>(table.radius);
    const Viewpoint view{
        .eye = lamp.position, .target = middle, .field_of_view = 2 * std::asin(reach / distance) * 180 / pi};
    return screen_matrix(view, resolution, resolution, 0.1 * distance, 2 * distance);
}

} // namespace course
