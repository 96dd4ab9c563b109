#include "display/osmesa_context.h"

#include <GL/osmesa.h>

#include "base/error.h"
#include "display/gl_context.h"

namespace brewster {

OsmesaContext::OsmesaContext() {
    constexpr int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_DEPTH_BITS,
                                  0,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context) {
        throw Error("no OpenGL 3.3 core context without a display", "OSMesa", "install libosmesa6 22 or later");
    }
    if (!OSMesaMakeCurrent(context, buffer_.data(), GL_UNSIGNED_BYTE, side, side)) {
        OSMesaDestroyContext(context);
        throw Error("the context cannot be made current", "OSMesa", "install libosmesa6 22 or later");
    }
    context_ = context;
    load_gl(OSMesaGetProcAddress);
}

OsmesaContext::~OsmesaContext() {
    OSMesaDestroyContext(static_cast<OSMesaContext>(context_));
}

}  // namespace brewster
