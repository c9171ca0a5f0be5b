// An OpenGL context to compute with, with or without a screen: one interface, three ways to get one.
#pragma once
#include "common/gl.hpp"

#include <memory>
#include <string>
#include <vector>

namespace course {

// A context that is current in the thread that made it, for as long as it lives. One at a time. Nothing is ever drawn
// into the screen that some of them have: whoever draws brings a framebuffer object.
class GlContext {
  public:
    virtual ~GlContext() = default;
    GlContext(const GlContext &) = delete;
    GlContext &operator=(const GlContext &) = delete;

    const Gl &gl() const { return gl_; }
    std::string renderer() const { return text(GL_RENDERER); } // who computes: a GPU's name, or llvmpipe
    std::string version() const { return text(GL_VERSION); }

  protected:
    // The context must be current. Throws InputError where its version is below the one that the course asks for:
    // not every library that finds a function's address has the function.
    explicit GlContext(Gl::GetProcAddress);

  private:
    std::string text(GLenum what) const;
    Gl gl_;
};

inline constexpr int gl_major = 4, gl_minor = 3;

// "osmesa" computes on the processor's cores and needs neither a GPU nor a screen; "egl" asks the machine's driver and
// needs no screen; "window" opens a hidden window and so needs one.
const std::vector<std::string> &context_names();

// Opens that context, or with "auto" the first that works in the order of context_names(). Throws InputError that says
// why there is none.
std::unique_ptr<GlContext> open_context(const std::string &name);

// The three ways, each in a file of its own, and throwing InputError where the build lacks the library.
std::unique_ptr<GlContext> open_osmesa();
std::unique_ptr<GlContext> open_egl();
std::unique_ptr<GlContext> open_hidden_window();

} // namespace course
