// Lesson 17, step 12: the live picture apart from its window. One pass after the other while nobody moves; coarser ones
// while somebody does.
#pragma once
#include "chapters/17_gpu/compare.hpp"

#include <chrono>
#include <cstdio>
#include <memory>

namespace course {

// What keys change.
struct LiveChoice {
    std::string walk = "stack", scene;
    bool specialised = true;
    int stack = 0;
    bool compute = false;

    static constexpr const char *keys = "T: walk with a stack or by skip pointers   G: a shader for this scene, or for "
                                        "any   F: fragment or compute shader   B: fewer bounces";
    std::string words(int bounces) const {
        return std::string(compute ? "compute" : "fragment") + " shader for " +
               (specialised ? "this scene" : "any scene") + ", walk: " + walk + ", " + std::to_string(bounces) +
               " bounces (T G F B)";
    }
};

// A live picture apart from its window: what is traced now, how coarse, and how many passes it has.
class LivePicture {
  public:
    LivePicture(const Gl &gl, Exhibit exhibit, LiveChoice choice)
        : gl_(gl), exhibit_(std::move(exhibit)), choice_(std::move(choice)), most_bounces_(bounces()),
          vertices_(make_vertex_array(gl)), show_(build_show(gl)) {
        build();
    }

    // Keys that it has a use for; the picture then starts anew.
    void press(char key) {
        if (key == 'T')
            choice_.walk = choice_.walk == "stack" ? "skip" : "stack";
        else if (key == 'G')
            choice_.specialised = !choice_.specialised;
        else if (key == 'F')
            choice_.compute = !choice_.compute;
        else if (key == 'B')
            exhibit_.scene.limits.bounces = bounces() > 0 ? bounces() / 2 : most_bounces_;
        else
            return;
        build();
    }

    // One more pass for this view, or the first one where it is another than before: then a coarse one if whole
    // pictures take longer than a blink.
    void advance(const Viewpoint &view, int width, int height) {
        const bool moved = fresh_ || view != view_ || width != width_ || height != height_;
        const int stride = moved && seconds_ > blink ? 4 : 1;
        if (moved || stride != stride_) {
            view_ = view, width_ = width, height_ = height, stride_ = stride;
            tracer_->start(view, std::max(1, width / stride), std::max(1, height / stride));
            passes_ = 0;
            fresh_ = false;
        }
        const auto start = std::chrono::steady_clock::now();
        tracer_->pass(passes_++);
        gl_.Finish();
        const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        pass_seconds_ = passed;
        if (stride == 1)
            seconds_ = passed;
    }
    bool is_of(const Viewpoint &view, int width, int height) const {
        return !fresh_ && stride_ == 1 && view == view_ && width == width_ && height == height_;
    }

    // Onto the window's own framebuffer.
    void show() const {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl_.Viewport(0, 0, width_, height_);
        gl_.Disable(GL_BLEND);
        gl_.UseProgram(show_);
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.BindTexture(GL_TEXTURE_2D, tracer_->sums().colours());
        gl_.Uniform1i(gl_.GetUniformLocation(show_, "sums"), 0);
        gl_.Uniform1i(gl_.GetUniformLocation(show_, "height"), height_);
        gl_.Uniform2f(gl_.GetUniformLocation(show_, "scale"), 1.0f / static_cast<float>(stride_),
                      1.0f / static_cast<float>(stride_));
        gl_.BindVertexArray(vertices_);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }

    int passes() const { return stride_ == 1 ? passes_ : 0; }
    Picture picture() const { return tracer_->picture(); }

    std::string title() const {
        char text[160];
        std::snprintf(text, sizeof text, "17_gpu %s | %d x %d | %d samples | %.1f ms a pass | ", choice_.scene.c_str(),
                      width_ / stride_, height_ / stride_, passes_, 1e3 * pass_seconds_);
        return text + choice_.words(bounces());
    }

  private:
    static constexpr double blink = 0.1; // seconds

    int bounces() const { return exhibit_.scene.limits.bounces; }

    static GlName build_show(const Gl &gl) {
        return link(gl, std::array{compile(gl, GL_VERTEX_SHADER, compose("screen.vert", {})),
                                   compile(gl, GL_FRAGMENT_SHADER, compose("show.frag", {}))});
    }

    void build() {
        PackedScene scene = choice_.specialised ? exhibit_.scene : with_everything(exhibit_.scene);
        scene.ray_stack = choice_.stack > 0 ? choice_.stack : std::max(1, bounces());
        Defines defines = shader_defines(scene, choice_.walk);
        if (choice_.compute)
            need(defines, "COMPUTE");
        tracer_ = std::make_unique<GpuTracer>(gl_, scene, defines);
        fresh_ = true;
    }

    const Gl &gl_;
    Exhibit exhibit_;
    LiveChoice choice_;
    int most_bounces_;
    GlName vertices_, show_;
    std::unique_ptr<GpuTracer> tracer_;
    Viewpoint view_;
    bool fresh_ = true; // nothing of this shader is drawn yet
    int width_ = 1, height_ = 1, stride_ = 1, passes_ = 0;
    double seconds_ = 0, pass_seconds_ = 0; // of the last whole pass, and of the last one
};

} // namespace course
