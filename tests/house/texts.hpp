// What the tests of the texts share: which Markdown files there are, and how to read them.
#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace texts {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

inline Lines lines_of(const fs::path &file) {
    Lines lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

inline std::string text_of(const fs::path &file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

inline std::string trimmed(const std::string &line) {
    const auto first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : line.substr(first, last - first + 1);
}

// Every text of the course that a reader follows: the pages at the top, and those in the folders below.
inline std::vector<fs::path> all_texts() {
    std::vector<fs::path> found;
    for (const auto &entry : fs::directory_iterator("."))
        if (entry.path().extension() == ".md")
            found.push_back(entry.path().filename());
    for (const char *folder : {"chapters", "tests", "exercises", "common", "shaders", "slides"})
        if (fs::exists(folder))
            for (const auto &entry : fs::recursive_directory_iterator(folder)) {
                const std::string path = entry.path().string();
                if (entry.path().extension() == ".md" && path.find("node_modules") == std::string::npos &&
                    !path.starts_with("exercises/work"))
                    found.push_back(entry.path());
            }
    std::ranges::sort(found);
    return found;
}

// The lines outside of code blocks, without `inline code`.
inline Lines prose_of(const fs::path &file) {
    Lines prose;
    bool in_code = false;
    for (const std::string &line : lines_of(file)) {
        if (trimmed(line).starts_with("```")) {
            in_code = !in_code;
            prose.emplace_back();
            continue;
        }
        std::string kept;
        bool quoted = false;
        for (const char c : line) {
            quoted ^= c == '`';
            if (!quoted && c != '`' && !in_code)
                kept += c;
        }
        prose.push_back(kept);
    }
    return prose;
}

// The chapters that have a program, as NN_name, in order.
inline std::vector<std::string> chapters() {
    std::vector<std::string> found;
    for (const auto &entry : fs::directory_iterator("chapters"))
        if (fs::exists(entry.path() / "main.cpp"))
            found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
}

} // namespace texts
