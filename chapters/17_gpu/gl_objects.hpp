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

// An array that shaders read as a samplerBuffer. Throws InputError where it is larger than the driver allows.
class TexelBuffer {
  public:
    // `room`: how many texels to make room for, where that is more than are given.
    template <class Texel> TexelBuffer(const Gl &gl, const std::string &what, GLenum format,
                                       std::span<const Texel> texels, std::size_t room = 0)
        : buffer_(make_buffer(gl)), texture_(make_texture(gl)) {
        room = std::max({room, texels.size(), std::size_t{1}}); // an empty buffer cannot be read at all
        GLint most = 0;
        gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
        if (room > static_cast<std::size_t>(most))
            throw InputError(what, std::to_string(room) + " texels are needed, and this driver's buffers hold " +
                                       std::to_string(most));
        gl.BindBuffer(GL_TEXTURE_BUFFER, buffer_);
        gl.BufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(room * sizeof(Texel)),
                      texels.size() == room ? texels.data() : nullptr, GL_STATIC_DRAW);
        if (gl.GetError() == GL_OUT_OF_MEMORY)
            throw InputError(what, "the GPU has no room for " + std::to_string(room * sizeof(Texel)) + " bytes");
        gl.BindTexture(GL_TEXTURE_BUFFER, texture_);
        gl.TexBuffer(GL_TEXTURE_BUFFER, format, buffer_);
    }
    GLuint texture() const { return texture_; }
    GLuint buffer() const { return buffer_; }

  private:
    GlName buffer_, texture_;
};

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

} // namespace course
