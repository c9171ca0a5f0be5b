// A window that is never shown, for drivers that give contexts to windows alone.
#include "common/errors.hpp"
#include "common/gl_context.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace course {
namespace {

class HiddenWindow {
  public:
    HiddenWindow() {
        if (!glfwInit())
            give_up();
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, gl_major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, gl_minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        GLFWwindow *window = glfwCreateWindow(16, 16, "course", nullptr, nullptr);
        if (!window)
            give_up();
        glfwMakeContextCurrent(window);
    }
    ~HiddenWindow() { glfwTerminate(); }
    HiddenWindow(const HiddenWindow &) = delete;
    HiddenWindow &operator=(const HiddenWindow &) = delete;

  private:
    [[noreturn]] static void give_up() {
        const char *why = nullptr;
        glfwGetError(&why);
        const std::string reason = why ? why : "no reason is given";
        glfwTerminate();
        throw InputError("window", reason);
    }
};

class WindowContext : HiddenWindow, public GlContext {
  public:
    WindowContext() : GlContext(glfwGetProcAddress) {}
};

} // namespace

std::unique_ptr<GlContext> open_hidden_window() { return std::make_unique<WindowContext>(); }

} // namespace course
