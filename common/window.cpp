#include "common/window.hpp"

#include "common/gl_window.hpp"
#include "common/progressive.hpp"
#include "common/screenshot.hpp"

#include <cstdio>

namespace course {
namespace {

constexpr double frame = 1.0 / 60; // seconds

// Copies a screen into the window: a texture, attached to a framebuffer object, and a blit. No shader has a say in
// the colours, so the bytes arrive as they are.
class ScreenCopier {
  public:
    explicit ScreenCopier(const Gl &gl) : gl_(gl) {
        gl_.GenTextures(1, &texture_);
        gl_.GenFramebuffers(1, &framebuffer_);
        gl_.BindTexture(GL_TEXTURE_2D, texture_);
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    }
    ~ScreenCopier() {
        gl_.DeleteFramebuffers(1, &framebuffer_);
        gl_.DeleteTextures(1, &texture_);
    }
    ScreenCopier(const ScreenCopier &) = delete;
    ScreenCopier &operator=(const ScreenCopier &) = delete;

    void upload(const Screen &screen) {
        if (screen.width == width_ && screen.height == height_) {
            gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, screen.pixels.data());
            return;
        }
        width_ = screen.width;
        height_ = screen.height;
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE, screen.pixels.data());
    }

    // Fills the window, stretching a picture that still has the size of before. OpenGL's rows count from below.
    void draw(int width, int height) const {
        if (width_ > 0)
            gl_.BlitFramebuffer(0, 0, width_, height_, 0, height, width, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

  private:
    const Gl &gl_;
    GLuint texture_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
};

std::string title_of(const std::string &name, const ProgressivePainter::State &state) {
    if (state.stride == 0)
        return name;
    const std::string level = state.busy ? " at 1/" + std::to_string(state.stride) : "";
    char text[160];
    std::snprintf(text, sizeof text, " | %d x %d%s | %.3f s, %.2f million rays a second | ", state.width, state.height,
                  level.c_str(), state.seconds, static_cast<double>(state.rays) / state.seconds / 1e6);
    return name + text + GlWindow::keys_in_short;
}

} // namespace

void show_in_window(const std::string &title, Viewpoint start, int width, int height, const Renderer &renderer) {
    GlWindow window(title, width, height, start);
    ScreenCopier copier(window.gl());
    ProgressivePainter painter(renderer);
    std::printf("%s\n", GlWindow::keys);
    std::fflush(stdout);
    Screen screen;
    Viewpoint viewpoint = start;
    width = height = 0; // of the view that is painted: none yet
    bool screenshot_wanted = false;
    while (!window.closed()) {
        if (width != window.width() || height != window.height() || viewpoint != window.viewpoint()) {
            viewpoint = window.viewpoint();
            width = window.width();
            height = window.height();
            painter.start(viewpoint, width, height);
        }
        // The state is read before the screen: once it says that nothing more will come, the screen is the last one.
        const ProgressivePainter::State state = painter.state();
        const bool fresh = painter.take_screen(screen), damaged = window.take_damage();
        if (fresh)
            copier.upload(screen);
        if (fresh || damaged) {
            copier.draw(width, height);
            window.swap_buffers();
        }
        window.set_title(title_of(title, state));

        for (const char key : window.take_keys())
            screenshot_wanted |= key == 'P';
        if (screenshot_wanted)
            if (const auto picture = painter.finished()) {
                save_screenshot(*picture);
                screenshot_wanted = false;
            }
        window.await_events(state.busy || window.flying() ? frame : 0);
    }
}

} // namespace course
