#include "display/gl_context.h"

#include <glad/gl.h>

#include "base/error.h"

namespace brewster {
namespace {

std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

const char* name_of(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        default:
            return "an unknown error";
    }
}

}  // namespace

void load_gl(GlLoader loader) {
    const int version = gladLoadGL(loader);
    if (version >= GLAD_MAKE_VERSION(3, 3)) return;
    const std::string found = version == 0 ? "no OpenGL function could be loaded"
                                           : "only OpenGL " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                                                 std::to_string(GLAD_VERSION_MINOR(version)) + " is there";
    throw Error(found, "graphics driver", "OpenGL 3.3 core is needed; draw without a display instead (brewster shot)");
}

std::string gl_description() {
    return text_of(GL_RENDERER) + ", OpenGL " + text_of(GL_VERSION);
}

void check_gl(const std::string& where) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    while (glGetError() != GL_NO_ERROR) continue;
    throw Error(std::string("the graphics driver reports ") + name_of(error), where,
                error == GL_OUT_OF_MEMORY ? "choose a smaller picture" : "please report it with " + gl_description());
}

}  // namespace brewster
