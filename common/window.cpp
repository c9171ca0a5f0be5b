// Stands in for window.cpp where GLFW is not installed.
#include "common/window.hpp"
#include "common/errors.hpp"

namespace course {

void show_in_window(const std::string &, Viewpoint, int, int, const Renderer &) {
    throw InputError("--window", "this build has no windows, because GLFW (libglfw3-dev) was not found");
}

} // namespace course
