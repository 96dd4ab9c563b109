#include "scene/validate.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/gltf_builder.h"
#include "scene/gltf_parse.h"
#include "scene/mutations.h"
#include "scene/scene.h"

namespace brewster {
namespace {

class Malformed : public testing::TestWithParam<Mutation> {};

std::string message_of(const std::string& text) {
    try {
        read_scene_text(text, "test");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Validate, TheUnchangedFileIsRead) {
    EXPECT_EQ(message_of(whole_file().text()), "no error");
}

TEST_P(Malformed, EndsInWords) {
    nlohmann::json file = nlohmann::json::parse(whole_file().text());
    GetParam().change(file);
    const std::string message = message_of(file.dump());
    EXPECT_NE(message.find(GetParam().words), std::string::npos) << message;
    EXPECT_EQ(message.rfind("test: ", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Files, Malformed, testing::ValuesIn(mutations()),
                         [](const auto& each) { return each.param.name; });

TEST(Validate, RestartsOfStrips) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_mesh("strip", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {255, 1, 2}}, 0, 5121);
    file.json["meshes"][0]["primitives"][0]["mode"] = 5;
    EXPECT_NE(message_of(file.text()).find("restarts its strip, which glTF forbids"), std::string::npos);
    file.json["accessors"][1]["count"] = 2;
    EXPECT_NE(message_of(file.text()).find("has 2 triangle corners, fewer than 3"), std::string::npos);
}

TEST(Validate, VertexIndicesBeyondTheVertices) {
    GltfBuilder file;
    file.add_material("grey", {0.5, 0.5, 0.5});
    file.add_mesh("bad", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 3}});
    EXPECT_NE(message_of(file.text()).find("indices\" holds vertex 3, but there are 3"), std::string::npos);
}

TEST(Validate, PositionsThatAreNotFinite) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        GltfBuilder file;
        file.add_material("grey", {0.5, 0.5, 0.5});
        file.add_mesh("bad", {{0, 0, 0}, {1, bad, 0}, {1, 1, 0}}, {{0, 1, 2}});
        EXPECT_NE(message_of(file.text()).find("not finite at vertex 1"), std::string::npos);
    }
}

TEST(Validate, BrokenTextIsLocated) {
    EXPECT_NE(message_of("{\n \"asset\": }").find("line 2"), std::string::npos);
    EXPECT_NE(message_of("").find("it is empty"), std::string::npos);
    EXPECT_NE(message_of("BLENDER-v304").find("it is not a glTF file; export the scene as"), std::string::npos);
    EXPECT_NE(message_of("[]").find("is not a JSON object"), std::string::npos);
    EXPECT_NE(message_of("{\"a\": 1e999}").find("JSON is broken"), std::string::npos);
    EXPECT_NE(message_of("{\"a\": \"\xff\"}").find("JSON is broken"), std::string::npos);
    EXPECT_NE(message_of(std::string(100000, '[')).find("64 levels deep"), std::string::npos);
}

// Every prefix of a file, and every byte of it replaced: an Error or a scene, never anything else. The sanitizers
// watch.
TEST(Validate, TruncatedAndScratchedFilesNeverCrash) {
    const std::string text = whole_file().text(), binary = whole_file().glb();
    int read = 0, refused = 0;
    const auto attempt = [&](const std::string& bytes) { message_of(bytes) == "no error" ? ++read : ++refused; };
    for (std::size_t length = 0; length < binary.size(); length += 3) attempt(binary.substr(0, length));
    for (std::size_t i = 0; i < text.size(); i += 3) {
        attempt(text.substr(0, i));
        for (const char c : {'\0', '9', '-', '"', '}', '\x80'}) {
            std::string scratched = text;
            scratched[i] = c;
            attempt(scratched);
        }
    }
    for (std::size_t i = 0; i < binary.size(); ++i) {
        std::string scratched = binary;
        scratched[i] = static_cast<char>(scratched[i] ^ 0xff);
        attempt(scratched);
    }
    EXPECT_GT(read, 100);  // a changed digit of a colour is still a file
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace brewster
