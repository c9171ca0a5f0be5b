// Lesson 17, step 10: the tracer's handle: a program made for one scene, its buffers, and its passes.
#pragma once
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/17_gpu/passes.hpp"
#include "chapters/17_gpu/prepare.hpp"
#include "chapters/17_gpu/specialise.hpp"
#include "chapters/17_gpu/sums.hpp"
#include "common/rendering.hpp"

#include <chrono>

namespace course {

class GpuTracer {
  public:
    // Throws InputError where the shader does not compile or the scene is too large for this driver.
    GpuTracer(const Gl &gl, const PackedScene &scene, const Defines &defines)
        : gl_(gl), computes_(defines.contains("COMPUTE")), strata_(scene.strata), program_(build(gl, defines)),
          vertices_(make_vertex_array(gl)), buffers_(gl), sums_(gl) {
        const PackedTrees &trees = scene.trees;
        buffers_.add("scene", GL_RGBA32F, scene.texels);
        buffers_.add("pictures", GL_RGBA32F, scene.pictures);
        buffers_.add("nodes", GL_RGBA32F, trees.nodes);
        buffers_.add("links", GL_RG32I, trees.links);
        buffers_.add("boxes", GL_RGBA32F, trees.boxes);
        buffers_.add("skips", GL_RG32I, trees.skips);
        buffers_.add("normals", GL_RGBA32F, trees.normals);
        buffers_.add("triangles", prepared_triangles(gl, vertices_, trees.corners));
        set_uniforms(scene);
    }

    // Forgets all passes. Sizes beyond the driver's limit throw InputError.
    void start(const Viewpoint &view, int width, int height) {
        sums_.start(width, height);
        set_camera(Camera(view, width, height));
    }

    // Drivers translate a shader for good only when it first draws. Draws one pixel and forgets it, so that the passes
    // that follow take the time of a pass. Returns the seconds that it took.
    double warm_up() {
        const auto start = std::chrono::steady_clock::now();
        draw(0, 1, 1);
        gl_.Finish();
        sums_.clear();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    // One more sample for every pixel, added to those before. Returns before the GPU is done.
    void pass(int number) { draw(number, sums_.width(), sums_.height()); }

    const Sums &sums() const { return sums_; }
    Picture picture() const { return sums_.picture(); }
    PassCounts counts() const { return sums_.counts(); }

  private:
    static ShaderProgram build(const Gl &gl, const Defines &defines) {
        if (defines.contains("COMPUTE"))
            return ShaderProgram(link(gl, std::array{compile(gl, GL_COMPUTE_SHADER, compose("trace.frag", defines))}));
        return ShaderProgram(link(gl, std::array{compile(gl, GL_VERTEX_SHADER, compose("screen.vert", {})),
                                                 compile(gl, GL_FRAGMENT_SHADER, compose("trace.frag", defines))}));
    }

    void draw(int pass, int width, int height) {
        sums_.bind();
        gl_.Viewport(0, 0, width, height);
        program_.use();
        program_.set("sample_place", glm::vec2(sample_place(pass)));
        program_.set("pass", pass);
        program_.set("lamp_cell", glm::vec2(lamp_cell(pass, strata_)));
        buffers_.bind();
        if (computes_)
            return compute(width, height);
        gl_.BindVertexArray(vertices_);
        gl_.Enable(GL_BLEND);
        gl_.BlendFunc(GL_ONE, GL_ONE);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }

    void compute(int width, int height) {
        gl_.BindImageTexture(0, sums_.colours(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
        gl_.BindImageTexture(1, sums_.counted(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
        program_.set("size", glm::ivec2(width, height));
        const auto squares = [](int pixels) { return static_cast<GLuint>((pixels + 7) / 8); };
        gl_.DispatchCompute(squares(width), squares(height), 1);
        gl_.MemoryBarrier(GL_ALL_BARRIER_BITS);
    }

    void set_uniforms(const PackedScene &scene) {
        program_.use();
        buffers_.tell(program_);
        std::vector<glm::ivec2> lists;
        for (const ShapeRun &run : scene.runs)
            lists.emplace_back(run.first, run.count);
        program_.set("lists", std::span<const glm::ivec2>(lists));
        program_.set("lights", glm::ivec2(scene.first_light, scene.light_count));
        program_.set("sky_table", scene.sky_table);
        program_.set("most_bounces", scene.limits.bounces);
        program_.set("least_weight", scene.limits.least_weight);
        program_.set("strata", static_cast<float>(strata_));
        program_.set("seed", glm::uvec2(scene.seed, scene.seed >> 32));
        for (const auto &[name, colour] : scene.colours)
            program_.set(name, colour);
    }

    void set_camera(const Camera &camera) {
        const Ray<double> corner = camera.ray(0, 0);
        program_.use();
        program_.set("camera_eye", Vec<float>(corner.origin));
        program_.set("camera_top_left", Vec<float>(corner.direction));
        program_.set("camera_across", Vec<float>(camera.ray(1, 0).direction - corner.direction));
        program_.set("camera_down", Vec<float>(camera.ray(0, 1).direction - corner.direction));
    }

    const Gl &gl_;
    bool computes_; // by a compute shader in place of a fragment shader
    int strata_;
    ShaderProgram program_;
    GlName vertices_;
    TexelUnits buffers_;
    Sums sums_;
};

} // namespace course
