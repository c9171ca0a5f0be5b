// Lesson 17, step 2: arrays that shaders read, and how a shader finds them.
#pragma once
#include "chapters/17_gpu/gl_objects.hpp"

#include <map>
#include <span>

namespace course {

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

// Buffers by their names in the shader, each on a texture unit of its own, from unit 0 on.
class TexelUnits {
  public:
    explicit TexelUnits(const Gl &gl) : gl_(gl) {}

    void add(const std::string &name, TexelBuffer buffer) { buffers_.emplace(name, std::move(buffer)); }
    template <class Texel> void add(const std::string &name, GLenum format, const std::vector<Texel> &texels) {
        add(name, TexelBuffer(gl_, name, format, std::span<const Texel>(texels)));
    }

    // Tells the shader which unit is which buffer's. Returns the first unit that is free.
    GLint tell(const ShaderProgram &program) const {
        GLint unit = 0;
        for (const auto &[name, buffer] : buffers_)
            program.set(name, unit++);
        return unit;
    }

    void bind() const {
        GLenum unit = GL_TEXTURE0;
        for (const auto &[name, buffer] : buffers_) {
            gl_.ActiveTexture(unit++);
            gl_.BindTexture(GL_TEXTURE_BUFFER, buffer.texture());
        }
    }

  private:
    const Gl &gl_;
    std::map<std::string, TexelBuffer> buffers_;
};

} // namespace course
