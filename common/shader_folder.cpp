#include "common/shader_folder.hpp"

namespace course {

const std::filesystem::path &shader_folder() {
    static const std::filesystem::path folder = COURSE_SHADERS; // CMake says so
    return folder;
}

} // namespace course
