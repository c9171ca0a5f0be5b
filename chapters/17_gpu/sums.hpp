// Lesson 17, step 10: what the passes add up in: a picture of floats, and beside it a count of what went on.
#pragma once
#include "chapters/17_gpu/gl_objects.hpp"

#include <array>
#include <cstdint>

namespace course {

// What went on behind a picture. Where one of the last two is not 0, the picture is wrong.
struct PassCounts {
    double rays = 0;            // in all pixels and passes
    double rays_not_kept = 0;   // that the ray stack had no room for
    std::int64_t cut_short = 0; // pixels whose loops were ended by the driver or by their bound
};

// Two textures of four floats a pixel: colours, with the number of passes in w, and counts. Their first row is the top.
class Sums {
  public:
    explicit Sums(const Gl &gl) : gl_(gl), frame_(make_framebuffer(gl)), targets_{make_texture(gl), make_texture(gl)} {}

    // All zero, in that size. Throws InputError beyond the driver's limit.
    void start(int width, int height) {
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
        if (gl_.GetError() == GL_OUT_OF_MEMORY)
            throw InputError("--width and --height", "the GPU has no room for so many pixels");
        if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw InputError("OpenGL", "this driver cannot draw into textures of floats");
        width_ = width;
        height_ = height;
        gl_.ClearColor(0, 0, 0, 0);
        clear();
    }

    void clear() const {
        bind();
        gl_.Clear(GL_COLOR_BUFFER_BIT);
    }
    void bind() const { gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_); }

    int width() const { return width_; }
    int height() const { return height_; }
    GLuint colours() const { return targets_[0]; }
    GLuint counted() const { return targets_[1]; }

    // The mean of all passes.
    Picture picture() const {
        Picture result(width_, height_);
        const auto sums = read(GL_COLOR_ATTACHMENT0);
        std::ranges::transform(sums, result.pixels.begin(), [](const glm::vec4 &sum) { return Colour(sum) / sum.w; });
        return result;
    }

    PassCounts counts() const {
        PassCounts sum;
        for (const glm::vec4 &pixel : read(GL_COLOR_ATTACHMENT1)) {
            sum.rays += static_cast<double>(pixel.x);
            sum.rays_not_kept += static_cast<double>(pixel.y);
            sum.cut_short += pixel.z > 0;
        }
        return sum;
    }

  private:
    std::vector<glm::vec4> read(GLenum attachment) const {
        bind();
        return read_pixels(gl_, attachment, width_, height_);
    }

    const Gl &gl_;
    GlName frame_;
    std::array<GlName, 2> targets_;
    int width_ = 0, height_ = 0;
};

} // namespace course
