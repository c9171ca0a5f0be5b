// The picture in a window, kept in a file.
#pragma once
#include "common/image.hpp"

namespace course {

// Writes the first of out/screenshot_1.png, _2, ... that is not there yet, and says which. A disk that is full closes
// no window: it is said on stderr.
void save_screenshot(const Picture &);

} // namespace course
