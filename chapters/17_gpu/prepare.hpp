// Lesson 17, step 9: the constants of the triangles' test, worked out by the GPU itself (A 3.2.2).
#pragma once
#include "chapters/17_gpu/texels.hpp"

namespace course {

// Three corners each become four texels: corner, normal, k1, k2. No fragment is drawn: what the vertex shader puts out
// for each triangle is caught in the buffer (transform feedback).
inline TexelBuffer prepared_triangles(const Gl &gl, GLuint vertices, const std::vector<glm::vec4> &corners) {
    const std::size_t count = corners.size() / 3;
    TexelBuffer prepared(gl, "triangles", GL_RGBA32F, std::span<const glm::vec4>(), 4 * count);
    if (count == 0)
        return prepared;
    const TexelBuffer given(gl, "corners", GL_RGBA32F, std::span<const glm::vec4>(corners));
    const std::array stages{compile(gl, GL_VERTEX_SHADER, compose("triangles.vert", {}))};
    const std::array outputs{"corner", "normal", "k1", "k2"};
    const GlName program = link(gl, stages, outputs);
    gl.UseProgram(program);
    gl.Uniform1i(gl.GetUniformLocation(program, "corners"), 0);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_BUFFER, given.texture());
    gl.BindVertexArray(vertices);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, prepared.buffer());
    gl.Enable(GL_RASTERIZER_DISCARD);
    gl.BeginTransformFeedback(GL_POINTS);
    gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    gl.EndTransformFeedback();
    gl.Disable(GL_RASTERIZER_DISCARD);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    return prepared;
}

} // namespace course
