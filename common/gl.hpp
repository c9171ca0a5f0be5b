// OpenGL's functions, asked of the context itself: one table for each context, and no GL library at link time.
#pragma once
#define GL_GLEXT_PROTOTYPES // the prototypes give each function its type; none of them is ever called
#include <GL/glcorearb.h>

namespace course {

// What the course calls, without the gl in front: a function more is a line more.
#define COURSE_GL_FUNCTIONS(F)                                                                                         \
    F(ActiveTexture)                                                                                                   \
    F(AttachShader)                                                                                                    \
    F(BeginTransformFeedback)                                                                                          \
    F(BindBuffer)                                                                                                      \
    F(BindBufferBase)                                                                                                  \
    F(BindFramebuffer)                                                                                                 \
    F(BindTexture)                                                                                                     \
    F(BindVertexArray)                                                                                                 \
    F(BlendFunc)                                                                                                       \
    F(BlitFramebuffer)                                                                                                 \
    F(BufferData)                                                                                                      \
    F(CheckFramebufferStatus)                                                                                          \
    F(Clear)                                                                                                           \
    F(ClearColor)                                                                                                      \
    F(CompileShader)                                                                                                   \
    F(CreateProgram)                                                                                                   \
    F(CreateShader)                                                                                                    \
    F(DeleteBuffers)                                                                                                   \
    F(DeleteFramebuffers)                                                                                              \
    F(DeleteProgram)                                                                                                   \
    F(DeleteShader)                                                                                                    \
    F(DeleteTextures)                                                                                                  \
    F(DeleteVertexArrays)                                                                                              \
    F(Disable)                                                                                                         \
    F(DrawArrays)                                                                                                      \
    F(DrawBuffers)                                                                                                     \
    F(DrawElements)                                                                                                    \
    F(Enable)                                                                                                          \
    F(EndTransformFeedback)                                                                                            \
    F(Finish)                                                                                                          \
    F(FramebufferTexture2D)                                                                                            \
    F(GenBuffers)                                                                                                      \
    F(GenFramebuffers)                                                                                                 \
    F(GenTextures)                                                                                                     \
    F(GenVertexArrays)                                                                                                 \
    F(GetBufferSubData)                                                                                                \
    F(GetError)                                                                                                        \
    F(GetIntegerv)                                                                                                     \
    F(GetProgramInfoLog)                                                                                               \
    F(GetProgramiv)                                                                                                    \
    F(GetShaderInfoLog)                                                                                                \
    F(GetShaderiv)                                                                                                     \
    F(GetString)                                                                                                       \
    F(GetUniformLocation)                                                                                              \
    F(LinkProgram)                                                                                                     \
    F(ReadBuffer)                                                                                                      \
    F(ReadPixels)                                                                                                      \
    F(ShaderSource)                                                                                                    \
    F(TexBuffer)                                                                                                       \
    F(TexImage2D)                                                                                                      \
    F(TexParameteri)                                                                                                   \
    F(TexSubImage2D)                                                                                                   \
    F(TransformFeedbackVaryings)                                                                                       \
    F(Uniform1f)                                                                                                       \
    F(Uniform1i)                                                                                                       \
    F(Uniform2f)                                                                                                       \
    F(Uniform2i)                                                                                                       \
    F(Uniform2iv)                                                                                                      \
    F(Uniform2ui)                                                                                                      \
    F(Uniform3f)                                                                                                       \
    F(UniformMatrix4fv)                                                                                                \
    F(UseProgram)                                                                                                      \
    F(Viewport)

// What only compute shaders need (4.3). A context that is older leaves them null.
#define COURSE_GL_COMPUTE_FUNCTIONS(F)                                                                                 \
    F(BindImageTexture)                                                                                                \
    F(DispatchCompute)                                                                                                 \
    F(MemoryBarrier)

// glClear(...) is written gl.Clear(...). The context must be current in the calling thread.
struct Gl {
    using Function = void (*)();
    using GetProcAddress =
        Function (*)(const char *name); // glfwGetProcAddress, OSMesaGetProcAddress, eglGetProcAddress

    // Asks the current context for every function of the list. Throws InputError naming the one that it lacks.
    explicit Gl(GetProcAddress);

#define COURSE_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    COURSE_GL_FUNCTIONS(COURSE_GL_MEMBER)
    COURSE_GL_COMPUTE_FUNCTIONS(COURSE_GL_MEMBER)
#undef COURSE_GL_MEMBER
};

} // namespace course
