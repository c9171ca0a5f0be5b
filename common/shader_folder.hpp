// Where the shaders of the tree are, wherever a program is started from.
#pragma once
#include <filesystem>

namespace course {

const std::filesystem::path &shader_folder();

} // namespace course
