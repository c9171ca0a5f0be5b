// The driver's own way to a context without a screen: a GPU by its device, or Mesa's platform without surfaces.
#include "common/errors.hpp"
#include "common/gl_context.hpp"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <array>
#include <cstring>
#include <string_view>

namespace course {
namespace {

bool lists(const char *extensions, std::string_view name) {
    return extensions && std::string_view(extensions).find(name) != std::string_view::npos;
}

template <class Function> Function egl_function(const char *name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

class Egl {
  public:
    Egl() {
        for (const EGLDisplay display : displays())
            if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) {
                display_ = display;
                if (make_current())
                    return;
                eglTerminate(display_);
            }
        throw InputError("egl", "no driver here gives an OpenGL " + std::to_string(gl_major) + "." +
                                    std::to_string(gl_minor) + " without a screen");
    }
    ~Egl() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }
    Egl(const Egl &) = delete;
    Egl &operator=(const Egl &) = delete;

  private:
    // GPUs first; then Mesa's platform, which computes on the processor where it has no better; then the default.
    static std::vector<EGLDisplay> displays() {
        std::vector<EGLDisplay> found;
        const char *extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        const auto of_platform = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        const auto query = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
        const auto ask = egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
        if (of_platform && query && ask && lists(extensions, "EGL_EXT_platform_device")) {
            std::array<EGLDeviceEXT, 16> devices{};
            EGLint count = 0;
            query(static_cast<EGLint>(devices.size()), devices.data(), &count);
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
                if (!lists(ask(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
                    found.push_back(of_platform(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        }
        if (of_platform && lists(extensions, "EGL_MESA_platform_surfaceless"))
            found.push_back(of_platform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        found.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
        return found;
    }

    bool make_current() {
        const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(display_, wanted.data(), &config, 1, &count) || count < 1)
            return false;
        const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               gl_major,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               gl_minor,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT)
            return false;
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            return true;
        eglDestroyContext(display_, context_);
        return false;
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

class EglContext : Egl, public GlContext {
  public:
    EglContext() : GlContext(eglGetProcAddress) {}
};

} // namespace

std::unique_ptr<GlContext> open_egl() { return std::make_unique<EglContext>(); }

} // namespace course
