// Lesson 17, step 10: what graphics cards were built for. The mesh on its table as triangles on the screen, each pixel
// keeping the nearest, with a shadow map for each lamp: to compare with.
#pragma once
#include "chapters/08_mesh/studio.hpp"
#include "chapters/17_gpu/gl_objects.hpp"
#include "chapters/17_gpu/screen_matrix.hpp"

#include <array>

namespace course {

class Rasteriser {
  public:
    static constexpr int resolution = 1024; // of the shadow maps

    Rasteriser(const Gl &gl, const Studio &studio)
        : gl_(gl), studio_(studio), lamps_(std::get<0>(studio.lights.kinds)), program_(build(gl, lamps_.size())),
          vertices_(make_vertex_array(gl)), indices_(make_buffer(gl)), frame_(make_framebuffer(gl)),
          colour_(make_texture(gl)), depth_(make_texture(gl)) {
        // A point that several triangles share is put in its place once.
        const Mesh<> &mesh = studio.mesh();
        std::vector<std::array<std::uint32_t, 3>> indices = mesh.indices;
        std::vector<glm::vec4> corners, normals, lights;
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            corners.emplace_back(mesh.points[i], 0);
            normals.emplace_back(mesh.normals.empty() ? Vec<float>(0) : mesh.normals[i], 0);
        }
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
        for (const PointLight &lamp : lamps_)
            lights.insert(lights.end(), {{Vec<float>(lamp.position), 0}, {lamp.intensity, 0}});
        buffers_.emplace("corners", TexelBuffer(gl, "corners", GL_RGBA32F, std::span<const glm::vec4>(corners)));
        buffers_.emplace("normals", TexelBuffer(gl, "normals", GL_RGBA32F, std::span<const glm::vec4>(normals)));
        buffers_.emplace("lamps", TexelBuffer(gl, "lamps", GL_RGBA32F, std::span<const glm::vec4>(lights)));
        for (std::size_t i = 0; i < lamps_.size(); ++i) {
            maps_.push_back(make_texture(gl));
            make_target(maps_.back(), GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, resolution, resolution);
        }
        set_uniforms();
    }

    // The whole picture: a map for each lamp, then what the eye sees. Returns before the GPU is done.
    void draw(const Viewpoint &view, int width, int height) {
        if (width != width_ || height != height_) {
            make_target(colour_, GL_RGBA32F, GL_RGBA, width, height);
            make_target(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, width, height);
            width_ = width, height_ = height;
        }
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        gl_.UseProgram(program_);
        gl_.Disable(GL_BLEND);
        gl_.Enable(GL_DEPTH_TEST);
        bind_buffers();
        constexpr GLenum none = GL_NONE, first = GL_COLOR_ATTACHMENT0;
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, first, GL_TEXTURE_2D, 0, 0);
        gl_.DrawBuffers(1, &none);
        for (std::size_t i = 0; i < maps_.size(); ++i)
            draw_into(maps_[i], lamp_matrix(i), resolution, resolution, true);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, first, GL_TEXTURE_2D, colour_, 0);
        gl_.DrawBuffers(1, &first);
        const Vec<float> eye(view.eye);
        gl_.Uniform3f(at("eye"), eye.x, eye.y, eye.z);
        bind_maps();
        const double distance = length(view.target - view.eye);
        draw_into(depth_, screen_matrix(view, width, height, 0.05 * distance, 20 * distance), width, height, false);
        gl_.Disable(GL_DEPTH_TEST);
    }

    // What no triangle covers is 0 in w: there the studio's backdrop is seen.
    Picture picture(const Viewpoint &view) const {
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
        gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
        Picture result(width_, height_);
        const Camera camera(view, width_, height_);
        for (int y = 0, i = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x, ++i) {
                const glm::vec4 &pixel = pixels[static_cast<std::size_t>(i)];
                result(x, y) = pixel.w > 0 ? Colour(pixel) : backdrop(camera.ray(x + 0.5, y + 0.5).direction);
            }
        return result;
    }

  private:
    static GlName build(const Gl &gl, std::size_t lamps) {
        const std::array stages{compile(gl, GL_VERTEX_SHADER, compose("raster.vert", {})),
                                compile(gl, GL_FRAGMENT_SHADER,
                                        compose("raster.frag", {{"LAMPS", std::to_string(lamps)},
                                                                {"RESOLUTION", std::to_string(resolution)}}))};
        return link(gl, stages);
    }

    void make_target(GLuint texture, GLenum kind, GLenum format, int width, int height) {
        gl_.BindTexture(GL_TEXTURE_2D, texture);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(kind), width, height, 0, format, GL_FLOAT, nullptr);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }

    // A lamp looks at the table's middle, and sees all of it.
    glm::mat4 lamp_matrix(std::size_t lamp) const {
        const Disk<> &table = std::get<1>(studio_.scene.shapes).front().shape;
        const Vec<double> middle(table.centre), place = lamps_[lamp].position;
        const double distance = length(middle - place), reach = 1.05 * static_cast<double>(table.radius);
        const Viewpoint view{
            .eye = place, .target = middle, .field_of_view = 2 * std::asin(reach / distance) * 180 / pi};
        return screen_matrix(view, resolution, resolution, 0.1 * distance, 2 * distance);
    }

    void draw_into(GLuint depth, const glm::mat4 &matrix, int width, int height, bool depth_only) {
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
        gl_.Viewport(0, 0, width, height);
        gl_.ClearColor(0, 0, 0, 0);
        gl_.Clear(GL_DEPTH_BUFFER_BIT | (depth_only ? 0 : GL_COLOR_BUFFER_BIT));
        gl_.UniformMatrix4fv(at("to_screen"), 1, GL_FALSE, &matrix[0][0]);
        gl_.Uniform1i(at("depth_only"), depth_only);
        gl_.BindVertexArray(vertices_);
        gl_.DrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    }

    void set_uniforms() {
        gl_.UseProgram(program_);
        const auto set = [&](const char *name, const Vec<float> &v) { gl_.Uniform3f(at(name), v.x, v.y, v.z); };
        const auto &[meshes, tables] = studio_.scene.shapes;
        set("mesh_colour", meshes.front().material.diffuse);
        set("table_colour", tables.front().material.diffuse);
        set("table_centre", tables.front().shape.centre);
        gl_.Uniform1f(at("table_radius"), tables.front().shape.radius);
        gl_.Uniform1i(at("mesh_triangles"), count_ / 3 - 2);
        GLint unit = 0;
        for (const auto &[name, buffer] : buffers_)
            gl_.Uniform1i(at(name.c_str()), unit++);
        for (std::size_t i = 0; i < maps_.size(); ++i) {
            const glm::mat4 matrix = lamp_matrix(i);
            const std::string number = "[" + std::to_string(i) + "]";
            gl_.Uniform1i(at(("shadow_maps" + number).c_str()), unit++);
            gl_.UniformMatrix4fv(at(("to_lamp" + number).c_str()), 1, GL_FALSE, &matrix[0][0]);
        }
    }

    void bind_buffers() {
        GLenum unit = GL_TEXTURE0;
        for (const auto &[name, buffer] : buffers_) {
            gl_.ActiveTexture(unit++);
            gl_.BindTexture(GL_TEXTURE_BUFFER, buffer.texture());
        }
        for (std::size_t i = 0; i < maps_.size(); ++i) { // not while they are drawn
            gl_.ActiveTexture(unit++);
            gl_.BindTexture(GL_TEXTURE_2D, 0);
        }
    }
    void bind_maps() {
        GLenum unit = GL_TEXTURE0 + static_cast<GLenum>(buffers_.size());
        for (const GlName &map : maps_) {
            gl_.ActiveTexture(unit++);
            gl_.BindTexture(GL_TEXTURE_2D, map);
        }
    }

    GLint at(const char *uniform) const { return gl_.GetUniformLocation(program_, uniform); }

    const Gl &gl_;
    const Studio &studio_;
    std::vector<PointLight> lamps_;
    GlName program_, vertices_, indices_, frame_, colour_, depth_;
    std::vector<GlName> maps_;
    std::map<std::string, TexelBuffer> buffers_;
    GLsizei count_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace course
