// What image_files.cpp asks of OpenImageIO. That and the 200 libraries that it brings take 0.2 s to load, so they stand in
// a library of their own, loaded with the first picture: a program that refuses a bad option does so at once.
#pragma once
#include "common/image.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace course {

// Both return what went wrong; nothing where all went well.
struct ImageLibrary {
    // The values as the file has them, in RGB; `linear` says whether they are floats.
    std::string (*read)(const std::string &file, Picture &picture, bool &linear);
    // Writes to `file` in the format of the name's ending: the encoded bytes, or where there are none the linear floats.
    std::string (*write)(const std::string &file, const std::string &name, const Picture &picture,
                         const std::vector<std::uint8_t> &bytes);
};
extern "C" const ImageLibrary course_image_library;

} // namespace course
