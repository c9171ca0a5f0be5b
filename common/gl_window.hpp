// A window on the screen with an OpenGL context and a viewer's hand on the camera (GLFW, in gl_window.cpp alone).
#pragma once
#include "common/gl.hpp"
#include "common/navigator.hpp"

#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace course {

// Left drag orbits, right drag looks around, the wheel zooms, WASD and the arrows fly, E and C rise and sink, R goes
// back to the start, Escape and Q close. One window at a time, made and used by the main thread.
class GlWindow {
  public:
    // Opens a window of that many pixels, or less where the screen is smaller, whose OpenGL (core, `major`.`minor` or
    // later) is current from then on. Throws InputError when no window can be had.
    GlWindow(const std::string &title, int width, int height, const Viewpoint &home, int major = 3, int minor = 3);
    ~GlWindow();
    GlWindow(const GlWindow &) = delete;
    GlWindow &operator=(const GlWindow &) = delete;

    const Gl &gl() const { return *gl_; }
    const Viewpoint &viewpoint() const { return navigator_.viewpoint(); }
    int width() const { return width_; } // in pixels, of what is drawn into; never 0
    int height() const { return height_; }
    bool closed() const;
    bool flying() const { return navigator_.flying(); } // a key is held: wait for events no longer than a frame

    // Waits until something happens, at most that many seconds (0: without an end), then lets a held key fly.
    void await_events(double seconds);

    // The keys pressed since the last call that the window has no use for itself, as capital letters and digits.
    std::vector<char> take_keys();

    // Something covered or moved the window: what it shows must be drawn again.
    bool take_damage();

    void set_title(const std::string &title);
    void swap_buffers(); // shows what was drawn

    static constexpr const char *keys =
        "left drag: orbit   right drag: look around   wheel: zoom   W A S D or arrows: fly   E, C: rise, sink\n"
        "R: back to the start   P: save a screenshot   Escape or Q: close";
    static constexpr const char *keys_in_short = "drag orbits, wheel zooms, WASD flies, R resets, P saves, Q closes";

  private:
    void connect_events();
    void on_key(int key, bool pressed);
    void on_pointer(double x, double y);

    Navigator navigator_;
    GLFWwindow *window_ = nullptr;
    std::optional<Gl> gl_;
    std::string title_;
    int width_ = 1, height_ = 1, button_ = -1; // the button that is held, or -1
    double pointer_x_ = 0, pointer_y_ = 0, last_time_ = 0;
    bool damaged_ = true;
    std::vector<char> keys_;
};

} // namespace course
