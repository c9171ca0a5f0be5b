// Runs a learner's GLSL: once for every case, in a fragment shader.
#pragma once
#include "exercises/grading/grading.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace course {

using Texel = std::array<float, 4>;

// Compiles `shader`, a fragment shader without its first line (#version), and runs it for `runs` pixels in a row. It
// reads the texels from `uniform samplerBuffer cases` and writes its result to `out vec4 result`; which run it is,
// int(gl_FragCoord.x) says. Throws InputError with the compiler's complaint, or where no OpenGL is to be had.
std::vector<Texel> run_shader(const std::string &shader, std::span<const Texel> texels, int runs);

// The same for an answer between what is given to it and the main() that asks it. A starter is not done; an answer that
// does not compile fails the check with the compiler's words.
std::vector<Texel> run_answer(Check &check, const GlslAnswer &answer, const std::string &given, const std::string &main,
                              std::span<const Texel> texels, int runs);

} // namespace course
