#include "display/shader_source.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "display/program.h"
#include "gl_test.h"
#include "image/temporary_folder.h"

namespace brewster {
namespace {

TEST(ShaderSource, SplicesIncludesOnceAndCountsLines) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("a.frag")) << "first\n#include \"b.glsl\"\nthird\n#include \"b.glsl\"\nfifth\n";
    std::ofstream(folder.file("b.glsl")) << "inner\n";
    set_shader_folder(folder.file(""));
    const ShaderSource source = shader_source("a.frag", {"ROWS 4"});
    set_shader_folder("");
    EXPECT_EQ(source.text,
              "#version 330 core\n#define BREWSTER_FUNCTION\n#define ROWS 4\n#line 1 0\nfirst\n#line 1 1\ninner\n"
              "#line 3 0\nthird\n#line 5 0\nfifth\n");
    EXPECT_EQ(source.files, (std::vector<std::string>{"a.frag", "b.glsl"}));
}

TEST(ShaderSource, ProgramCarriesItsOwnShaders) {
    EXPECT_NE(shader_source("chart.frag").text.find("BinValue look_up("), std::string::npos);
    EXPECT_THROW(shader_source("missing.frag"), Error);
}

TEST(ShaderSource, MissingFileIsSaid) {
    set_shader_folder("/nowhere");
    EXPECT_THROW(shader_source("chart.frag"), Error);
    set_shader_folder("");
}

class ProgramTest : public GlTest {};

TEST_F(ProgramTest, CompilerMessageNamesTheFile) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("a.vert")) << "void main() { gl_Position = vec4(0); }\n";
    std::ofstream(folder.file("a.frag")) << "out vec4 colour;\nvoid main() {\n    colour = missing;\n}\n";
    set_shader_folder(folder.file(""));
    try {
        const Program program("a.vert", "a.frag");
        ADD_FAILURE() << "no error";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("missing"), std::string::npos);
        EXPECT_NE(text.find("0:3"), std::string::npos) << text;
        EXPECT_NE(text.find("0 = a.frag"), std::string::npos);
    }
    set_shader_folder("");
}

TEST_F(ProgramTest, UnknownUniformIsSaid) {
    const Program program("text.vert", "text.frag");
    EXPECT_NO_THROW(program.set("screen_size", glm::vec2(1, 1)));
    EXPECT_THROW(program.set("screen_sise", glm::vec2(1, 1)), Error);
}

}  // namespace
}  // namespace brewster
