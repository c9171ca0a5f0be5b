// OpenGL's functions, asked of the context itself: one table for each context, and no GL library at link time.
#pragma once
#define GL_GLEXT_PROTOTYPES // the prototypes give each function its type; none of them is ever called
#include <GL/glcorearb.h>

namespace course {

// What the course calls, without the gl in front: a function more is a line more.
#define COURSE_GL_FUNCTIONS(F)                                                                                         \
    F(BindFramebuffer)                                                                                                 \
    F(BindTexture)                                                                                                     \
    F(BlitFramebuffer)                                                                                                 \
    F(DeleteFramebuffers)                                                                                              \
    F(DeleteTextures)                                                                                                  \
    F(FramebufferTexture2D)                                                                                            \
    F(GenFramebuffers)                                                                                                 \
    F(GenTextures)                                                                                                     \
    F(TexImage2D)                                                                                                      \
    F(TexSubImage2D)

// glClear(...) is written gl.Clear(...). The context must be current in the calling thread.
struct Gl {
    using Function = void (*)();
    using GetProcAddress =
        Function (*)(const char *name); // glfwGetProcAddress, OSMesaGetProcAddress, eglGetProcAddress

    // Asks the current context for every function of the list. Throws InputError naming the one that it lacks.
    explicit Gl(GetProcAddress);

#define COURSE_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    COURSE_GL_FUNCTIONS(COURSE_GL_MEMBER)
#undef COURSE_GL_MEMBER
};

} // namespace course
