#include "common/gl_context.hpp"

#include "common/errors.hpp"

namespace course {

GlContext::GlContext(Gl::GetProcAddress find) : gl_(find) {
    GLint major = 0, minor = 0;
    gl_.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl_.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major < gl_major || (major == gl_major && minor < gl_minor))
        throw InputError("OpenGL", "version " + std::to_string(gl_major) + "." + std::to_string(gl_minor) +
                                       " is needed, and this driver has " + version());
}

std::string GlContext::text(GLenum what) const {
    const GLubyte *bytes = gl_.GetString(what);
    return bytes ? reinterpret_cast<const char *>(bytes) : "unknown";
}

const std::vector<std::string> &context_names() {
    static const std::vector<std::string> names{"osmesa", "egl", "window"};
    return names;
}

std::unique_ptr<GlContext> open_context(const std::string &name) {
    if (name == "osmesa")
        return open_osmesa();
    if (name == "egl")
        return open_egl();
    if (name == "window")
        return open_hidden_window();
    std::string reasons;
    for (const std::string &one : context_names())
        try {
            return open_context(one);
        } catch (const InputError &error) {
            reasons += (reasons.empty() ? "" : "; ") + std::string(error.what());
        }
    throw InputError("--context", "no OpenGL context is to be had (" + reasons + ")");
}

} // namespace course
