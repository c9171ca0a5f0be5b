#include "common/screenshot.hpp"

#include "common/errors.hpp"
#include "common/image_files.hpp"

#include <cstdio>
#include <filesystem>

namespace course {

void save_screenshot(const Picture &picture) {
    int number = 1;
    std::string file;
    do
        file = "out/screenshot_" + std::to_string(number++) + ".png";
    while (std::filesystem::exists(file));
    try {
        write_image(file, picture);
        std::printf("saved %s\n", file.c_str());
        std::fflush(stdout);
    } catch (const InputError &error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
}

} // namespace course
