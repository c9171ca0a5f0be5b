#include "common/gl_window.hpp"

#include "common/errors.hpp"

#include <algorithm>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <utility>

namespace course {
namespace {

[[noreturn]] void give_up() {
    const char *why = nullptr;
    glfwGetError(&why);
    const std::string reason = why ? why : "no reason is given";
    glfwTerminate();
    throw InputError("--window", "no window can be opened here (" + reason + ")");
}

std::optional<Motion> motion_of(int key) {
    switch (key) {
    case GLFW_KEY_W:
    case GLFW_KEY_UP:
        return Motion::forward;
    case GLFW_KEY_S:
    case GLFW_KEY_DOWN:
        return Motion::back;
    case GLFW_KEY_A:
    case GLFW_KEY_LEFT:
        return Motion::left;
    case GLFW_KEY_D:
    case GLFW_KEY_RIGHT:
        return Motion::right;
    case GLFW_KEY_E:
    case GLFW_KEY_PAGE_UP:
        return Motion::up;
    case GLFW_KEY_C:
    case GLFW_KEY_PAGE_DOWN:
        return Motion::down;
    default:
        return std::nullopt;
    }
}

// Shrinks a size to what the screen has room for, keeping its shape.
std::pair<int, int> fitted_to_screen(int width, int height) {
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    if (!monitor)
        return {width, height};
    int x, y, room_across, room_down;
    glfwGetMonitorWorkarea(monitor, &x, &y, &room_across, &room_down);
    const double scale =
        std::min({1.0, static_cast<double>(room_across) / width, static_cast<double>(room_down) / height});
    return {std::max(1, static_cast<int>(width * scale)), std::max(1, static_cast<int>(height * scale))};
}

GlWindow &of(GLFWwindow *window) { return *static_cast<GlWindow *>(glfwGetWindowUserPointer(window)); }

} // namespace

GlWindow::GlWindow(const std::string &title, int width, int height, const Viewpoint &home, int major, int minor)
    : navigator_(home), title_(title) {
    if (!glfwInit())
        give_up();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // the only core profile that macOS has
    const auto [across, down] = fitted_to_screen(width, height);
    window_ = glfwCreateWindow(across, down, title.c_str(), nullptr, nullptr);
    if (!window_)
        give_up();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    try {
        gl_.emplace(glfwGetProcAddress);
    } catch (...) {
        glfwTerminate();
        throw;
    }
    glfwGetFramebufferSize(window_, &width_, &height_);
    glfwGetCursorPos(window_, &pointer_x_, &pointer_y_);
    connect_events();
    last_time_ = glfwGetTime();
}

GlWindow::~GlWindow() { glfwTerminate(); }

void GlWindow::connect_events() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow *window, int width, int height) {
        if (width > 0 && height > 0) { // a window put away has no size at all
            of(window).width_ = width;
            of(window).height_ = height;
        }
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow *window) { of(window).damaged_ = true; });
    glfwSetKeyCallback(window_, [](GLFWwindow *window, int key, int, int action, int) {
        if (action != GLFW_REPEAT)
            of(window).on_key(key, action == GLFW_PRESS);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow *window, int button, int action, int) {
        of(window).button_ = action == GLFW_PRESS ? button : -1; // where it is, its last move has told
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow *window, double x, double y) { of(window).on_pointer(x, y); });
    glfwSetScrollCallback(window_,
                          [](GLFWwindow *window, double, double notches) { of(window).navigator_.zoom(notches); });
}

void GlWindow::on_key(int key, bool pressed) {
    if (const auto motion = motion_of(key))
        return pressed ? navigator_.press(*motion) : navigator_.release(*motion);
    if (!pressed)
        return;
    if (key == GLFW_KEY_ESCAPE || key == GLFW_KEY_Q)
        glfwSetWindowShouldClose(window_, GLFW_TRUE);
    else if (key == GLFW_KEY_R)
        navigator_.reset();
    else if (key < 128) // GLFW numbers letters and digits as ASCII does
        keys_.push_back(static_cast<char>(key));
}

void GlWindow::on_pointer(double x, double y) {
    int across, down; // in the pointer's unit, which need not be a pixel
    glfwGetWindowSize(window_, &across, &down);
    const double dx = (x - std::exchange(pointer_x_, x)) / std::max(1, down);
    const double dy = (y - std::exchange(pointer_y_, y)) / std::max(1, down);
    if (button_ == GLFW_MOUSE_BUTTON_LEFT)
        navigator_.orbit(dx, dy);
    else if (button_ == GLFW_MOUSE_BUTTON_RIGHT)
        navigator_.look(dx, dy);
}

bool GlWindow::closed() const { return glfwWindowShouldClose(window_) != 0; }

void GlWindow::await_events(double seconds) {
    const bool was_flying = flying();
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwWaitEvents();
    const double now = glfwGetTime(), passed = now - std::exchange(last_time_, now);
    if (was_flying) // else the wait was not the flight's
        navigator_.elapse(std::min(passed, 0.1));
}

std::vector<char> GlWindow::take_keys() { return std::exchange(keys_, {}); }

bool GlWindow::take_damage() { return std::exchange(damaged_, false); }

void GlWindow::set_title(const std::string &title) {
    if (std::exchange(title_, title) != title)
        glfwSetWindowTitle(window_, title.c_str());
}

void GlWindow::swap_buffers() { glfwSwapBuffers(window_); }

} // namespace course
