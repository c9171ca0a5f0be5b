// A window that shows a picture while it is made, and a camera that the viewer moves (GLFW, in window.cpp alone).
#pragma once
#include "common/rendering.hpp"

#include <string>

namespace course {

// Opens a window and renders into it until the viewer closes it (Escape or Q), starting anew, coarse first, whenever
// the camera moves or the window changes its size. Throws InputError when no window can be had.
void show_in_window(const std::string &title, Viewpoint start, int width, int height, const Renderer &renderer);

} // namespace course
