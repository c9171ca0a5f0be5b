// Output files that appear whole or not at all.
#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace course {

// Throws InputError unless a file could be written there now; makes the folders above it.
void require_writable(const std::filesystem::path &file);

// Calls write(beside) with a name next to `file` (same ending), then renames it over `file`; on any exception the
// half-written file is removed and `file` stays as it was.
void replace_file(const std::filesystem::path &file,
                  const std::function<void(const std::filesystem::path &beside)> &write);

// The same for a text.
void write_text(const std::filesystem::path &file, std::string_view text);

} // namespace course
