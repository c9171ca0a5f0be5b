#include "common/output_files.hpp"

#include "common/errors.hpp"

#include <fstream>
#include <string>
#include <system_error>
#include <unistd.h>

namespace course {
namespace {

// A name in the same folder, so that the rename stays within one file system, with the ending that writers look at.
std::filesystem::path name_beside(const std::filesystem::path &file) {
    std::string name = "." + file.stem().string();
    name.append(".part").append(std::to_string(getpid())).append(file.extension().string());
    return file.parent_path() / name;
}

} // namespace

void require_writable(const std::filesystem::path &file) {
    std::error_code not_there, error;
    if (file.filename().empty() || std::filesystem::is_directory(file, not_there))
        throw InputError(file.string(), "is a folder, not a file");
    if (!file.parent_path().empty())
        std::filesystem::create_directories(file.parent_path(), error);
    if (error)
        throw InputError(file.string(), "its folder cannot be made (" + error.message() + ")");
    const auto beside = name_beside(file);
    const bool opened = std::ofstream(beside).is_open();
    std::filesystem::remove(beside, error);
    if (!opened || (std::filesystem::exists(file) && !std::filesystem::is_regular_file(file)))
        throw InputError(file.string(), "cannot be written");
}

void replace_file(const std::filesystem::path &file, const std::function<void(const std::filesystem::path &)> &write) {
    const auto beside = name_beside(file);
    std::error_code error;
    try {
        write(beside);
        std::filesystem::rename(beside, file, error);
        if (error)
            throw InputError(file.string(), "cannot be written (" + error.message() + ")");
    } catch (...) {
        std::filesystem::remove(beside, error);
        throw;
    }
}

void write_text(const std::filesystem::path &file, std::string_view text) {
    require_writable(file);
    replace_file(file, [&](const std::filesystem::path &beside) {
        std::ofstream out(beside, std::ios::binary);
        out << text << std::flush;
        if (!out)
            throw InputError(file.string(), "cannot be written in full");
    });
}

} // namespace course
