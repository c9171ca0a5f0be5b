#include "tests/hard_cases/shader_rows.hpp"

#include "chapters/17_gpu/prepare.hpp"
#include "common/timing.hpp"

#include <condition_variable>
#include <cstdio>
#include <functional>
#include <future>
#include <mutex>
#include <queue>
#include <thread>

namespace course::hard {
namespace {

constexpr int row = 64; // pixels of the picture that the answers are

// What is kept in the context between two batches.
class Probe {
  public:
    explicit Probe(const Gl &gl)
        : gl_(gl), vertices_(make_vertex_array(gl)), frame_(make_framebuffer(gl)), target_(make_texture(gl)) {}

    double run(const std::string &shape, const std::vector<Ray<float>> &rays, const ShaderShapes &shapes,
               std::span<double> t, int rounds) {
        std::vector<glm::vec4> texels;
        for (const Ray<float> &ray : rays)
            texels.insert(texels.end(), {{ray.origin, ray.t_max}, {ray.direction, ray.t_min}});
        const TexelBuffer given(gl_, "rays", GL_RGBA32F, std::span<const glm::vec4>(texels));
        const TexelBuffer scene(gl_, "scene", GL_RGBA32F, std::span<const glm::vec4>(shapes.scene));
        const TexelBuffer triangles = shapes.corners.empty() ? TexelBuffer(gl_, "triangles", GL_RGBA32F,
                                                                           std::span<const glm::vec4>(shapes.triangles))
                                                             : prepared_triangles(gl_, vertices_, shapes.corners);
        const Defines defines{{"SHAPE_AT", shape + "_at"}, {"SHAPE_SIZE", shape + "_size"}, {"LIST_COUNT", "1"}};
        begin("probe.frag", defines, {{"rays", &given}, {"scene", &scene}, {"triangles", &triangles}}, rays.size());
        double seconds = 0;
        if (rounds > 1)
            seconds = median_seconds({[&] { draw(); }}, rounds).front();
        else
            draw();
        const auto pixels = read_pixels(gl_, GL_COLOR_ATTACHMENT0, row, rows_of(rays.size()));
        for (std::size_t i = 0; i < t.size(); ++i)
            t[i] = static_cast<double>(pixels[i].x);
        return seconds;
    }

    std::vector<glm::vec4> optics(std::span<const glm::vec4> boundaries) {
        const TexelBuffer given(gl_, "boundaries", GL_RGBA32F, boundaries);
        begin("probe_optics.frag", {{"HAS_GLASS", ""}}, {{"boundaries", &given}}, boundaries.size());
        draw();
        auto pixels = read_pixels(gl_, GL_COLOR_ATTACHMENT0, row, rows_of(boundaries.size()));
        pixels.resize(boundaries.size());
        return pixels;
    }

  private:
    static int rows_of(std::size_t count) { return (static_cast<int>(count) + row - 1) / row; }

    // All that a drawing needs: the program, its buffers, and a picture that has a pixel for each question.
    void begin(const std::string &file, const Defines &defines,
               const std::map<std::string, const TexelBuffer *> &buffers, std::size_t questions) {
        use_frame(rows_of(questions));
        const GLuint program = program_for(file, defines);
        gl_.UseProgram(program);
        GLint unit = 0;
        for (const auto &[name, buffer] : buffers) {
            gl_.Uniform1i(gl_.GetUniformLocation(program, name.c_str()), unit);
            gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit++));
            gl_.BindTexture(GL_TEXTURE_BUFFER, buffer->texture());
        }
        gl_.BindVertexArray(vertices_);
    }

    void draw() {
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
        gl_.Finish();
    }

    GLuint program_for(const std::string &file, Defines defines) {
        const auto known = programs_.find({file, defines});
        if (known != programs_.end())
            return known->second;
        const std::pair key{file, defines};
        defines["ROW"] = std::to_string(row);
        const std::array stages{compile(gl_, GL_VERTEX_SHADER, compose("screen.vert", {})),
                                compile(gl_, GL_FRAGMENT_SHADER, compose(file, defines))};
        return programs_.emplace(key, link(gl_, stages)).first->second;
    }

    void use_frame(int height) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
        if (height > height_) {
            gl_.BindTexture(GL_TEXTURE_2D, target_);
            gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, row, height, 0, GL_RGBA, GL_FLOAT, nullptr);
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_, 0);
            height_ = height;
        }
        gl_.Viewport(0, 0, row, height);
    }

    const Gl &gl_;
    GlName vertices_, frame_, target_;
    std::map<std::pair<std::string, Defines>, GlName> programs_;
    int height_ = 0;
};

// A context belongs to the thread that opened it, and the suites work on several.
class ShaderThread : public Shaders {
  public:
    ShaderThread() {
        std::promise<std::string> opened;
        auto said = opened.get_future();
        thread_ = std::jthread([this, &opened](const std::stop_token &stop) { work(stop, opened); });
        renderer_ = said.get(); // or the InputError
    }

    double run(const std::string &shape, const std::vector<Ray<float>> &rays, const ShaderShapes &shapes,
               std::span<double> t, int rounds) override {
        double seconds = 0;
        wait_for([&](Probe &probe) { seconds = probe.run(shape, rays, shapes, t, rounds); });
        return seconds;
    }

    std::vector<glm::vec4> optics(std::span<const glm::vec4> boundaries) override {
        std::vector<glm::vec4> answers;
        wait_for([&](Probe &probe) { answers = probe.optics(boundaries); });
        return answers;
    }

    const std::string &renderer() const { return renderer_; }

  private:
    void wait_for(const std::function<void(Probe &)> &asked) {
        std::packaged_task<void(Probe &)> task(asked);
        auto done = task.get_future();
        {
            const std::lock_guard lock(mutex_);
            tasks_.push(std::move(task));
        }
        wanted_.notify_one();
        done.get(); // or what it threw
    }

    void work(const std::stop_token &stop, std::promise<std::string> &opened) {
        std::unique_ptr<GlContext> context;
        try {
            context = open_context("auto");
            opened.set_value(context->renderer());
        } catch (...) {
            opened.set_exception(std::current_exception());
            return;
        }
        Probe probe(context->gl());
        std::unique_lock lock(mutex_);
        while (wanted_.wait(lock, stop, [&] { return !tasks_.empty(); })) {
            auto task = std::move(tasks_.front());
            tasks_.pop();
            lock.unlock();
            task(probe);
            lock.lock();
        }
    }

    std::string renderer_;
    std::mutex mutex_;
    std::condition_variable_any wanted_;
    std::queue<std::packaged_task<void(Probe &)>> tasks_;
    std::jthread thread_; // last, so that it ends before the rest goes
};

} // namespace

std::shared_ptr<Shaders> open_shaders() {
    try {
        auto shaders = std::make_shared<ShaderThread>();
        std::fprintf(stderr, "The rows named GLSL are computed by %s.\n", shaders->renderer().c_str());
        return shaders;
    } catch (const InputError &error) {
        std::fprintf(stderr, "The rows of the shaders are left out: %s\n", error.what());
        return nullptr;
    }
}

} // namespace course::hard
