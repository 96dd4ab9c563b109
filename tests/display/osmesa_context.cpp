#include "display/osmesa_context.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "display/gl_context.h"

namespace brewster {
namespace {

TEST(OsmesaContext, IsOpenGl33OrMore) {
    const OsmesaContext context;
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 33);
    EXPECT_NE(gl_description().find("OpenGL"), std::string::npos);
}

TEST(OsmesaContext, AnotherMayFollow) {
    for (int i = 0; i < 3; ++i) {
        const OsmesaContext context;
        EXPECT_NO_THROW(check_gl("a fresh context"));
    }
}

TEST(GlContext, ErrorIsSaidOnce) {
    const OsmesaContext context;
    glEnable(0xdead);
    EXPECT_THROW(check_gl("a wrong call"), Error);
    EXPECT_NO_THROW(check_gl("a right call"));
}

TEST(GlContext, LoaderWithoutFunctionsIsSaid) {
    EXPECT_THROW(load_gl([](const char*) -> GlFunction { return nullptr; }), Error);
}

}  // namespace
}  // namespace brewster
