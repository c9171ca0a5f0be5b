#include "exercises/grading/shader_runs.hpp"

#include "chapters/17_gpu/texels.hpp"
#include "common/errors.hpp"

namespace course {

std::vector<Texel> run_shader(const std::string &shader, std::span<const Texel> texels, int runs) {
    static const std::unique_ptr<GlContext> context = open_context("auto");
    const Gl &gl = context->gl();
    const TexelBuffer cases(gl, "cases", GL_RGBA32F, texels);
    const GlName target = make_texture(gl), frame = make_framebuffer(gl), vertices = make_vertex_array(gl);
    gl.BindTexture(GL_TEXTURE_2D, target);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, runs, 1, 0, GL_RGBA, GL_FLOAT, nullptr);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    gl.Viewport(0, 0, runs, 1);

    const std::array stages{
        compile(gl, GL_VERTEX_SHADER, compose("screen.vert", {})),
        compile(gl, GL_FRAGMENT_SHADER, ShaderText{"#version 430 core\n" + shader, {"your answer"}})};
    const GlName program = link(gl, stages);
    gl.UseProgram(program);
    gl.Uniform1i(gl.GetUniformLocation(program, "cases"), 0);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_BUFFER, cases.texture());
    gl.BindVertexArray(vertices);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);

    std::vector<Texel> results(static_cast<std::size_t>(runs));
    gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.ReadPixels(0, 0, runs, 1, GL_RGBA, GL_FLOAT, results.data());
    return results;
}

std::vector<Texel> run_answer(Check &check, const GlslAnswer &answer, const std::string &given, const std::string &main,
                              std::span<const Texel> texels, int runs) {
    if (answer.text.find("NOT_DONE") != std::string::npos)
        throw NotDone{};
    try {
        return run_shader("uniform samplerBuffer cases;\nout vec4 result;\n" + given + "\n#line 1 0\n" + answer.text +
                              "\n#line 1 0\n" + main,
                          texels, runs);
    } catch (const InputError &error) {
        check.fail("a shader that compiles", error.what());
    }
}

} // namespace course
