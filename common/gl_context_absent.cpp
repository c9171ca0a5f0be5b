// In place of the libraries that this build does without. CMake says which those are.
#include "common/errors.hpp"
#include "common/gl_context.hpp"

namespace course {

#ifdef COURSE_WITHOUT_OSMESA
std::unique_ptr<GlContext> open_osmesa() { throw InputError("osmesa", "this build has no OSMesa"); }
#endif
#ifdef COURSE_WITHOUT_EGL
std::unique_ptr<GlContext> open_egl() { throw InputError("egl", "this build has no EGL"); }
#endif
#ifdef COURSE_WITHOUT_GLFW
std::unique_ptr<GlContext> open_hidden_window() { throw InputError("window", "this build has no GLFW"); }
#endif

} // namespace course
