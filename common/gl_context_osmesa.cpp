// Mesa's off-screen library. Its header brings the old <GL/gl.h> along, so it is included here and nowhere else.
#include "common/errors.hpp"
#include "common/gl_context.hpp"

#include <GL/osmesa.h>
#include <array>

namespace course {
namespace {

class OsMesa {
  public:
    OsMesa() {
        const std::array wanted{OSMESA_FORMAT,
                                OSMESA_RGBA,
                                OSMESA_PROFILE,
                                OSMESA_CORE_PROFILE,
                                OSMESA_CONTEXT_MAJOR_VERSION,
                                gl_major,
                                OSMESA_CONTEXT_MINOR_VERSION,
                                gl_minor,
                                0};
        context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
        if (!context_ || !OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
            close();
            throw InputError("osmesa",
                             "this OSMesa has no OpenGL " + std::to_string(gl_major) + "." + std::to_string(gl_minor));
        }
    }
    ~OsMesa() { close(); }
    OsMesa(const OsMesa &) = delete;
    OsMesa &operator=(const OsMesa &) = delete;

  private:
    void close() {
        OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        if (context_)
            OSMesaDestroyContext(context_);
    }

    OSMesaContext context_;
    std::array<unsigned char, 4> pixel_{}; // the screen that it insists on
};

class OffScreenContext : OsMesa, public GlContext {
  public:
    OffScreenContext() : GlContext(OSMesaGetProcAddress) {}
};

} // namespace

std::unique_ptr<GlContext> open_osmesa() { return std::make_unique<OffScreenContext>(); }

} // namespace course
