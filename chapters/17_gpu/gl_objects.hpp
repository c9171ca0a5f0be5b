// Lesson 17, step 2: what a context holds for us, owned and deleted as C++ does.
#pragma once
#include "chapters/17_gpu/compose.hpp"
#include "common/gl_context.hpp"
#include "common/image.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace course {

// One OpenGL name, deleted with its owner.
class GlName {
  public:
    using Delete = void (*)(const Gl &, GLuint);
    GlName(const Gl &gl, GLuint name, Delete remove) : gl_(&gl), name_(name), delete_(remove) {}
    ~GlName() {
        if (name_)
            delete_(*gl_, name_);
    }
    GlName(GlName &&other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)), delete_(other.delete_) {}
    GlName &operator=(GlName &&other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        std::swap(delete_, other.delete_);
        return *this;
    }
    operator GLuint() const { return name_; }
    const Gl &gl() const { return *gl_; }

  private:
    const Gl *gl_;
    GLuint name_;
    Delete delete_;
};

inline GlName make_texture(const Gl &gl) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    return {gl, name, [](const Gl &with, GLuint old) { with.DeleteTextures(1, &old); }};
}
inline GlName make_buffer(const Gl &gl) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    return {gl, name, [](const Gl &with, GLuint old) { with.DeleteBuffers(1, &old); }};
}
inline GlName make_framebuffer(const Gl &gl) {
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    return {gl, name, [](const Gl &with, GLuint old) { with.DeleteFramebuffers(1, &old); }};
}
inline GlName make_vertex_array(const Gl &gl) {
    GLuint name = 0;
    gl.GenVertexArrays(1, &name);
    return {gl, name, [](const Gl &with, GLuint old) { with.DeleteVertexArrays(1, &old); }};
}

// Compiles one stage. Throws InputError with the file, the line and the compiler's first complaint.
inline GlName compile(const Gl &gl, GLenum stage, const ShaderText &shader) {
    GlName name(gl, gl.CreateShader(stage), [](const Gl &with, GLuint old) { with.DeleteShader(old); });
    const char *text = shader.text.c_str();
    gl.ShaderSource(name, 1, &text, nullptr);
    gl.CompileShader(name);
    GLint fine = 0;
    gl.GetShaderiv(name, GL_COMPILE_STATUS, &fine);
    if (!fine) {
        std::string log(4096, '\0');
        gl.GetShaderInfoLog(name, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw InputError("shader", first_complaint(shader, log.c_str()));
    }
    return name;
}

// A program of one or two stages; `captured` are the outputs of a vertex shader that are kept in a buffer.
inline GlName link(const Gl &gl, std::span<const GlName> stages, std::span<const char *const> captured = {}) {
    GlName name(gl, gl.CreateProgram(), [](const Gl &with, GLuint old) { with.DeleteProgram(old); });
    for (const GlName &stage : stages)
        gl.AttachShader(name, stage);
    if (!captured.empty())
        gl.TransformFeedbackVaryings(name, static_cast<GLsizei>(captured.size()), captured.data(),
                                     GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(name);
    GLint fine = 0;
    gl.GetProgramiv(name, GL_LINK_STATUS, &fine);
    if (!fine) {
        std::string log(4096, '\0');
        gl.GetProgramInfoLog(name, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw InputError("shader", "does not link: " + std::string(log.c_str()).substr(0, log.find('\n')));
    }
    return name;
}

// A program in use and its uniforms, by name. A name that the compiler has thrown out is set without effect.
class ShaderProgram {
  public:
    explicit ShaderProgram(GlName linked) : name_(std::move(linked)) {}

    void use() const { gl().UseProgram(name_); }

    // The program must be in use.
    void set(const std::string &name, GLint value) const { gl().Uniform1i(at(name), value); }
    void set(const std::string &name, float value) const { gl().Uniform1f(at(name), value); }
    void set(const std::string &name, const glm::vec2 &v) const { gl().Uniform2f(at(name), v.x, v.y); }
    void set(const std::string &name, const glm::ivec2 &v) const { gl().Uniform2i(at(name), v.x, v.y); }
    void set(const std::string &name, const glm::uvec2 &v) const { gl().Uniform2ui(at(name), v.x, v.y); }
    void set(const std::string &name, const glm::vec3 &v) const { gl().Uniform3f(at(name), v.x, v.y, v.z); }
    void set(const std::string &name, const glm::mat4 &m) const {
        gl().UniformMatrix4fv(at(name), 1, GL_FALSE, &m[0][0]);
    }
    void set(const std::string &name, std::span<const glm::ivec2> list) const {
        gl().Uniform2iv(at(name), static_cast<GLsizei>(list.size()), list.empty() ? nullptr : &list[0].x);
    }

  private:
    const Gl &gl() const { return name_.gl(); }
    GLint at(const std::string &uniform) const { return gl().GetUniformLocation(name_, uniform.c_str()); }

    GlName name_;
};

// What lies in the framebuffer that is bound.
inline std::vector<glm::vec4> read_pixels(const Gl &gl, GLenum attachment, int width, int height) {
    std::vector<glm::vec4> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    gl.ReadBuffer(attachment);
    gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

} // namespace course
