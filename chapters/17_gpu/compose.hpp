// Lesson 17, step 1: a shader out of many files. GLSL has no #include, so the course brings one of ten lines.
#pragma once
#include "common/errors.hpp"
#include "common/shader_folder.hpp"

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace course {

// What is put before a shader as #define NAME VALUE. The values may be empty.
using Defines = std::map<std::string, std::string>;

// A shader's text and the files that it came from: #line tells the compiler which line of which file follows.
struct ShaderText {
    std::string text;
    std::vector<std::string> files;
};

// Appends the file, with every include line replaced by the lines of the file that it names.
inline void append_file(ShaderText &shader, const std::string &name) {
    std::ifstream file(shader_folder() / name);
    if (!file)
        throw InputError((shader_folder() / name).string(), "cannot be read");
    const std::size_t number = shader.files.size();
    shader.files.push_back(name);
    const auto line_is = [&](int line) {
        shader.text += "#line " + std::to_string(line) + " " + std::to_string(number) + "\n";
    };
    const std::string include = "#include \"";
    line_is(1);
    int count = 0;
    for (std::string line; std::getline(file, line);) {
        ++count;
        if (line.starts_with(include) && line.ends_with('"')) {
            append_file(shader, line.substr(include.size(), line.size() - include.size() - 1));
            line_is(count + 1);
        } else
            shader.text += line + "\n";
    }
}

inline ShaderText compose(const std::string &name, const Defines &defines) {
    ShaderText shader{"#version 430 core\n", {}};
    for (const auto &[macro, value] : defines)
        shader.text += "#define " + macro + (value.empty() ? "" : " " + value) + "\n";
    append_file(shader, name);
    return shader;
}

// The compiler's first complaint, with the file's name for its number: compilers write 3:12(5) or 3(12).
inline std::string first_complaint(const ShaderText &shader, const std::string &log) {
    const std::string line = log.substr(0, log.find('\n'));
    for (std::size_t at = 0; at < line.size(); ++at) {
        unsigned file = 0, number = 0;
        int length = 0;
        if (std::isdigit(static_cast<unsigned char>(line[at])) &&
            std::sscanf(line.c_str() + at, "%u%*1[:(]%u%n", &file, &number, &length) == 2 && file < shader.files.size())
            return shader.files[file] + ":" + std::to_string(number) +
                   line.substr(at + static_cast<std::size_t>(length));
    }
    return line;
}

} // namespace course
