// Lesson 17, step 10: what graphics cards were built for. The mesh on its table as triangles on the screen, each pixel
// keeping the nearest, with a shadow map for each lamp: to compare with.
#pragma once
#include "chapters/17_gpu/raster_mesh.hpp"

namespace course {

class Rasteriser {
  public:
    static constexpr int resolution = 1024; // of the shadow maps

    Rasteriser(const Gl &gl, const Studio &studio)
        : gl_(gl), mesh_(gl, studio), program_(build(gl, std::get<0>(studio.lights.kinds).size())),
          frame_(make_framebuffer(gl)), colour_(make_texture(gl)), depth_(make_texture(gl)) {
        for (const PointLight &lamp : std::get<0>(studio.lights.kinds)) {
            maps_.push_back(make_texture(gl));
            make_target(maps_.back(), GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, resolution, resolution);
            to_lamp_.push_back(lamp_matrix(studio, lamp, resolution));
        }
        set_uniforms(studio);
    }

    // The whole picture: a map for each lamp, then what the eye sees. Returns before the GPU is done.
    void draw(const Viewpoint &view, int width, int height) {
        if (width != width_ || height != height_) {
            make_target(colour_, GL_RGBA32F, GL_RGBA, width, height);
            make_target(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, width, height);
            width_ = width, height_ = height;
        }
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        program_.use();
        gl_.Disable(GL_BLEND);
        gl_.Enable(GL_DEPTH_TEST);
        mesh_.buffers().bind();
        bind_maps(false);
        constexpr GLenum none = GL_NONE, first = GL_COLOR_ATTACHMENT0;
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, first, GL_TEXTURE_2D, 0, 0);
        gl_.DrawBuffers(1, &none);
        for (std::size_t i = 0; i < maps_.size(); ++i)
            draw_into(maps_[i], to_lamp_[i], resolution, resolution, true);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, first, GL_TEXTURE_2D, colour_, 0);
        gl_.DrawBuffers(1, &first);
        program_.set("eye", Vec<float>(view.eye));
        bind_maps(true);
        const double distance = length(view.target - view.eye);
        draw_into(depth_, screen_matrix(view, width, height, 0.05 * distance, 20 * distance), width, height, false);
        gl_.Disable(GL_DEPTH_TEST);
    }

    // What no triangle covers is 0 in w: there the studio's backdrop is seen.
    Picture picture(const Viewpoint &view) const {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        const auto pixels = read_pixels(gl_, GL_COLOR_ATTACHMENT0, width_, height_);
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
    static ShaderProgram build(const Gl &gl, std::size_t lamps) {
        const Defines defines{{"LAMPS", std::to_string(lamps)}, {"RESOLUTION", std::to_string(resolution)}};
        return ShaderProgram(link(gl, std::array{compile(gl, GL_VERTEX_SHADER, compose("raster.vert", {})),
                                                 compile(gl, GL_FRAGMENT_SHADER, compose("raster.frag", defines))}));
    }

    void make_target(GLuint texture, GLenum kind, GLenum format, int width, int height) {
        gl_.BindTexture(GL_TEXTURE_2D, texture);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(kind), width, height, 0, format, GL_FLOAT, nullptr);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    }

    void draw_into(GLuint depth, const glm::mat4 &matrix, int width, int height, bool depth_only) {
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
        gl_.Viewport(0, 0, width, height);
        gl_.ClearColor(0, 0, 0, 0);
        gl_.Clear(GL_DEPTH_BUFFER_BIT | (depth_only ? 0 : GL_COLOR_BUFFER_BIT));
        program_.set("to_screen", matrix);
        program_.set("depth_only", static_cast<GLint>(depth_only));
        mesh_.draw();
    }

    void set_uniforms(const Studio &studio) {
        program_.use();
        const auto &[meshes, tables] = studio.scene.shapes;
        program_.set("mesh_colour", meshes.front().material.diffuse);
        program_.set("table_colour", tables.front().material.diffuse);
        program_.set("table_centre", tables.front().shape.centre);
        program_.set("table_radius", tables.front().shape.radius);
        program_.set("mesh_triangles", mesh_.mesh_triangles());
        first_map_ = mesh_.buffers().tell(program_);
        for (std::size_t i = 0; i < maps_.size(); ++i) {
            const std::string number = std::string("[").append(std::to_string(i)).append("]");
            program_.set("shadow_maps" + number, first_map_ + static_cast<GLint>(i));
            program_.set("to_lamp" + number, to_lamp_[i]);
        }
    }

    // Not while they are drawn.
    void bind_maps(bool bound) const {
        GLenum unit = GL_TEXTURE0 + static_cast<GLenum>(first_map_);
        for (const GlName &map : maps_) {
            gl_.ActiveTexture(unit++);
            gl_.BindTexture(GL_TEXTURE_2D, bound ? GLuint{map} : 0);
        }
    }

    const Gl &gl_;
    RasterMesh mesh_;
    ShaderProgram program_;
    GlName frame_, colour_, depth_;
    std::vector<GlName> maps_;
    std::vector<glm::mat4> to_lamp_;
    GLint first_map_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace course
