#include "common/gl.hpp"

#include "common/errors.hpp"

#include <string>

namespace course {
namespace {

template <class F> void load(F &function, Gl::GetProcAddress find, const char *name) {
    function = reinterpret_cast<F>(find(name));
    if (!function)
        throw InputError("OpenGL", std::string("this driver has no ") + name);
}

} // namespace

Gl::Gl(GetProcAddress find) {
#define COURSE_GL_LOAD(name) load(name, find, "gl" #name);
    COURSE_GL_FUNCTIONS(COURSE_GL_LOAD)
#undef COURSE_GL_LOAD
#define COURSE_GL_LOAD(name) name = reinterpret_cast<decltype(name)>(find("gl" #name));
    COURSE_GL_COMPUTE_FUNCTIONS(COURSE_GL_LOAD)
#undef COURSE_GL_LOAD
}

} // namespace course
