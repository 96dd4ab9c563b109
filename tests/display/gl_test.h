#pragma once
#include <gtest/gtest.h>

#include "display/gl_context.h"
#include "display/osmesa_context.h"

namespace brewster {

/// A test that draws: it has a context of its own and fails for any OpenGL error and any word of the shader compiler.
class GlTest : public testing::Test {
  protected:
    GlTest() { testing::internal::CaptureStderr(); }
    void TearDown() override {
        EXPECT_NO_THROW(check_gl("the test"));
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    }

    OsmesaContext context_;
};

}  // namespace brewster
