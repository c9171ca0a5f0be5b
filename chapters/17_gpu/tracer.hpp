// Lesson 17, step 10: the tracer's handle: a program made for one scene, its buffers, and the sum of the passes so far.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/17_gpu/prepare.hpp"
#include "chapters/17_gpu/specialise.hpp"
#include "common/rendering.hpp"

#include <array>
#include <chrono>

namespace course {

class GpuTracer {
  public:
    // Throws InputError where the shader does not compile or the scene is too large for this driver.
    GpuTracer(const Gl &gl, const PackedScene &scene, const Defines &defines)
        : gl_(gl), computes_(defines.contains("COMPUTE")), program_(build(gl, defines)),
          vertices_(make_vertex_array(gl)), frame_(make_framebuffer(gl)), targets_{make_texture(gl), make_texture(gl)} {
        const PackedTrees &trees = scene.trees;
        fill("scene", GL_RGBA32F, scene.texels);
        fill("pictures", GL_RGBA32F, scene.pictures);
        fill("nodes", GL_RGBA32F, trees.nodes);
        fill("links", GL_RG32I, trees.links);
        fill("boxes", GL_RGBA32F, trees.boxes);
        fill("skips", GL_RG32I, trees.skips);
        fill("normals", GL_RGBA32F, trees.normals);
        buffers_.emplace("triangles", prepared_triangles(gl, vertices_, trees.corners));
        set_uniforms(scene);
    }

    // Forgets all passes. Sizes beyond the driver's limit throw InputError.
    void start(const Viewpoint &view, int width, int height) {
        GLint most = 0;
        gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
        if (width > most || height > most)
            throw InputError("--width and --height", "this driver draws at most " + std::to_string(most) + " pixels");
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        for (GLuint i = 0; i < targets_.size(); ++i) {
            gl_.BindTexture(GL_TEXTURE_2D, targets_[i]);
            gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST); // it has no smaller copies
            if (width != width_ || height != height_)
                gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_TEXTURE_2D, targets_[i], 0);
        }
        constexpr std::array<GLenum, 2> both{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        gl_.DrawBuffers(2, both.data());
        if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw InputError("OpenGL", "this driver cannot draw into textures of floats");
        width_ = width;
        height_ = height;
        gl_.ClearColor(0, 0, 0, 0);
        gl_.Clear(GL_COLOR_BUFFER_BIT);
        set_camera(Camera(view, width, height));
    }

    // Drivers translate a shader for good only when it first draws. Draws one pixel and forgets it, so that the passes
    // that follow take the time of a pass. Returns the seconds that it took.
    double warm_up() {
        const auto start = std::chrono::steady_clock::now();
        draw({0.5f, 0.5f}, 1, 1);
        gl_.Finish();
        gl_.Clear(GL_COLOR_BUFFER_BIT);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    // One more sample for every pixel, at this place within it, added to those before. Returns before the GPU is done.
    void pass(const glm::vec2 &place) { draw(place, width_, height_); }

    // The texture in which the passes are added up: colours, and in w how many they are. Its first row is the top one.
    GLuint sums() const { return targets_[0]; }

    // The mean of all passes.
    Picture picture() const {
        Picture result(width_, height_);
        const auto sums = read(GL_COLOR_ATTACHMENT0);
        std::ranges::transform(sums, result.pixels.begin(), [](const glm::vec4 &sum) { return Colour(sum) / sum.w; });
        return result;
    }

    // What went on behind the picture. Where one of the last two is not 0, the picture is wrong.
    struct Counts {
        double rays = 0;            // in all pixels and passes
        double rays_not_kept = 0;   // that the ray stack had no room for
        std::int64_t cut_short = 0; // pixels whose loops were ended by the driver or by their bound
    };
    Counts counts() const {
        Counts sum;
        for (const glm::vec4 &pixel : read(GL_COLOR_ATTACHMENT1)) {
            sum.rays += static_cast<double>(pixel.x);
            sum.rays_not_kept += static_cast<double>(pixel.y);
            sum.cut_short += pixel.z > 0;
        }
        return sum;
    }

  private:
    static GlName build(const Gl &gl, const Defines &defines) {
        if (defines.contains("COMPUTE"))
            return link(gl, std::array{compile(gl, GL_COMPUTE_SHADER, compose("trace.frag", defines))});
        const std::array stages{compile(gl, GL_VERTEX_SHADER, compose("screen.vert", {})),
                                compile(gl, GL_FRAGMENT_SHADER, compose("trace.frag", defines))};
        return link(gl, stages);
    }

    void draw(const glm::vec2 &place, int width, int height) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        gl_.Viewport(0, 0, width, height);
        gl_.UseProgram(program_);
        gl_.Uniform2f(at("sample_place"), place.x, place.y);
        GLenum unit = GL_TEXTURE0;
        for (const auto &[name, buffer] : buffers_) {
            gl_.ActiveTexture(unit++);
            gl_.BindTexture(GL_TEXTURE_BUFFER, buffer.texture());
        }
        if (computes_)
            return compute(width, height);
        gl_.BindVertexArray(vertices_);
        gl_.Enable(GL_BLEND);
        gl_.BlendFunc(GL_ONE, GL_ONE);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }

    void compute(int width, int height) {
        for (GLuint i = 0; i < targets_.size(); ++i)
            gl_.BindImageTexture(i, targets_[i], 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
        gl_.Uniform2i(at("size"), width, height);
        const auto squares = [](int pixels) { return static_cast<GLuint>((pixels + 7) / 8); };
        gl_.DispatchCompute(squares(width), squares(height), 1);
        gl_.MemoryBarrier(GL_ALL_BARRIER_BITS);
    }

    template <class Texel> void fill(const std::string &name, GLenum format, const std::vector<Texel> &texels) {
        buffers_.emplace(name, TexelBuffer(gl_, name, format, std::span<const Texel>(texels)));
    }

    void set_uniforms(const PackedScene &scene) {
        gl_.UseProgram(program_);
        GLint unit = 0;
        for (const auto &[name, buffer] : buffers_)
            gl_.Uniform1i(at(name.c_str()), unit++);
        std::vector<GLint> lists;
        for (const ShapeRun &run : scene.runs)
            lists.insert(lists.end(), {run.first, run.count});
        gl_.Uniform2iv(at("lists"), static_cast<GLsizei>(scene.runs.size()), lists.data());
        gl_.Uniform2i(at("lights"), scene.first_light, scene.light_count);
        gl_.Uniform1i(at("sky_table"), scene.sky_table);
        gl_.Uniform1i(at("most_bounces"), scene.limits.bounces);
        gl_.Uniform1f(at("least_weight"), scene.limits.least_weight);
        for (const auto &[name, colour] : scene.colours)
            gl_.Uniform3f(at(name.c_str()), colour.r, colour.g, colour.b);
    }

    GLint at(const char *uniform) const { return gl_.GetUniformLocation(program_, uniform); }

    void set_camera(const Camera &camera) {
        const Ray<double> corner = camera.ray(0, 0);
        gl_.UseProgram(program_);
        const auto set = [&](const char *name, const Vec<double> &v) {
            const Vec<float> rounded(v);
            gl_.Uniform3f(at(name), rounded.x, rounded.y, rounded.z);
        };
        set("camera_eye", corner.origin);
        set("camera_top_left", corner.direction);
        set("camera_across", camera.ray(1, 0).direction - corner.direction);
        set("camera_down", camera.ray(0, 1).direction - corner.direction);
    }

    std::vector<glm::vec4> read(GLenum attachment) const {
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        gl_.ReadBuffer(attachment);
        gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
        return pixels;
    }

    const Gl &gl_;
    bool computes_; // by a compute shader in place of a fragment shader
    GlName program_;
    std::map<std::string, TexelBuffer> buffers_; // by their names in the shader
    GlName vertices_, frame_;
    std::array<GlName, 2> targets_;
    int width_ = 0, height_ = 0;
};

} // namespace course
