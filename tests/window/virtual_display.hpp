// An X server without a screen (Xvfb), whose pixels lie in a file.
#pragma once
#include "common/image_files.hpp"
#include "tests/window/process.hpp"

#include <array>
#include <cstdint>

namespace course {

// Whether a program is on the path.
inline bool installed(const std::string &program) {
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0)
            return true;
    return false;
}

class VirtualDisplay {
  public:
    static constexpr int width = 800, height = 600;

    // Starts a server under a number that is free; name() is empty when that failed.
    explicit VirtualDisplay(const std::filesystem::path &folder, const std::vector<std::string> &more = {})
        : pixels_(without_old_file(folder / "Xvfb_screen0")), server_(command(folder, more), folder) {
        comes_true([&] { return text_of(folder / "stdout.txt").ends_with("\n") || server_.ended(); });
        if (const std::string number = text_of(folder / "stdout.txt"); !number.empty())
            name_ = ":" + number.substr(0, number.find('\n'));
    }

    const std::string &name() const { return name_; }

    // What the screen shows in its top left corner, where a window without a window manager stands. An XWD file: 25
    // big-endian words, a name, the colour map (12 bytes an entry), then rows of 32-bit pixels, blue first.
    Picture corner(int across, int down) const {
        const std::string file = text_of(pixels_);
        const auto word = [&](std::size_t i) {
            std::uint32_t value = 0;
            for (std::size_t byte = 4 * i; byte < 4 * i + 4; ++byte)
                value = value << 8 | static_cast<unsigned char>(file.at(byte));
            return value;
        };
        const std::size_t header = word(0), row = word(12), colours = word(19), start = header + 12 * colours;
        Picture picture(across, down);
        for (int y = 0; y < down; ++y)
            for (int x = 0; x < across; ++x) {
                const std::size_t at = start + static_cast<std::size_t>(y) * row + 4 * static_cast<std::size_t>(x);
                const auto channel = [&](std::size_t i) { return linear(static_cast<unsigned char>(file.at(at + i))); };
                picture(x, y) = {channel(2), channel(1), channel(0)};
            }
        return picture;
    }

  private:
    static float linear(unsigned char byte) {
        static const auto all = [] {
            std::array<float, 256> table;
            for (std::size_t i = 0; i < table.size(); ++i)
                table[i] = linear_from_srgb(static_cast<float>(i) / 255);
            return table;
        }();
        return all[byte];
    }

    static std::filesystem::path without_old_file(const std::filesystem::path &file) {
        std::filesystem::remove(file);
        return file;
    }

    static std::vector<std::string> command(const std::filesystem::path &folder, const std::vector<std::string> &more) {
        const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
        std::vector<std::string> words{"Xvfb",    "-displayfd", "1",    "-fbdir",    folder.string(),
                                       "-screen", "0",          screen, "-nolisten", "tcp"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    std::filesystem::path pixels_;
    Process server_;
    std::string name_;
};

} // namespace course
