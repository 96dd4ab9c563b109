#include "bins/lookup.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "display/render_target.h"
#include "display/shader_source.h"
#include "display/upload.h"
#include "gl_test.h"
#include "hand_made.h"
#include "image/temporary_folder.h"

namespace brewster {
namespace {

constexpr int side = 100;  ///< 1e4 points
constexpr std::size_t small_limit = 65536;

struct Answers {
    std::vector<float> value, standard_error, place;
};

class Lookup : public GlTest {
  protected:
    Lookup() {
        std::filesystem::copy(BREWSTER_SOURCE_DIR "/shaders", folder_.file("shaders"),
                              std::filesystem::copy_options::recursive);
        std::filesystem::copy(BREWSTER_SOURCE_DIR "/tests/display/lookup.frag", folder_.file("shaders"));
        set_shader_folder(folder_.file("shaders"));
        std::mt19937 random(11);
        for (const int leaves : {1, 2, 9, 300, 30000}) {
            const std::uint32_t root = hand_made::add_random_tree(*bins_, leaves, random);
            bins_->charts.push_back({root, root, 0, 0});
        }
        const auto uniform = [&] { return std::uniform_real_distribution(-0.01f, 1.01f)(random); };
        for (int i = 0; i < side * side; ++i) {
            points_.emplace_back(uniform(), uniform(), static_cast<float>(i % 5), 0.0f);
        }
        bins_->version = 1;
    }
    ~Lookup() override { set_shader_folder(""); }

    /// What the shader says, the points row by row from the upper left.
    Answers ask(std::size_t largest_buffer_texture) {
        const TexelStorage storage = texel_storage(largest_buffer_texture);
        BinUpload upload(storage);
        upload.submit(bins_);
        while (!upload.advance(100000)) continue;  // in pieces that begin and end inside rows
        const Program program("full_screen.vert", "lookup.frag", texel_defines(storage));
        const RenderTarget target(side, side, 3, false);
        const Texture points = Texture::create();
        std::vector<glm::vec4> texels;  // GL's first row is the lowest
        for (auto row = points_.end(); row != points_.begin(); row -= side)
            texels.insert(texels.end(), row - side, row);
        glActiveTexture(GL_TEXTURE5);
        glBindTexture(GL_TEXTURE_2D, points.id());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side, side, 0, GL_RGBA, GL_FLOAT, texels.data());
        program.set("points", 5);
        upload.bind(program, 0);
        const VertexArray no_vertices = VertexArray::create();
        glBindVertexArray(no_vertices.id());
        target.bind();
        target.clear();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        return {target.read(0), target.read(1), target.read(2)};
    }

    void expect_agreement(const Answers& answers) {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const std::uint32_t u = lookup::fixed_point_of(points_[i].x), v = lookup::fixed_point_of(points_[i].y);
            const std::uint32_t root = bins_->charts[static_cast<std::size_t>(points_[i].z)].direct_root;
            const lookup::BinValue expected = lookup::look_up(*bins_, root, 0u, u, v);
            ASSERT_EQ(answers.place[4 * i], static_cast<float>(u)) << "point " << i;
            ASSERT_EQ(answers.place[4 * i + 1], static_cast<float>(v)) << "point " << i;
            for (int band = 0; band < 3; ++band) {
                const std::size_t k = 4 * i + static_cast<std::size_t>(band);
                ASSERT_NEAR(answers.value[k], expected.value[band], 1e-5f * expected.value[band]) << "point " << i;
                ASSERT_EQ(answers.standard_error[k], expected.standard_error[band]) << "point " << i;
            }
        }
    }

    TemporaryFolder folder_;
    std::shared_ptr<Snapshot> bins_ = std::make_shared<Snapshot>();
    std::vector<glm::vec4> points_;
};

// (u, v) become integers first, so both sides descend to the same leaf; there only the order of a few float operations
// may differ. Points on borders are not left out: there is no need to.
TEST_F(Lookup, ShaderAgreesWithProcessor) {
    ASSERT_EQ(texel_storage(std::size_t{1} << 27), TexelStorage::buffer_texture);
    expect_agreement(ask(std::size_t{1} << 27));
}

TEST_F(Lookup, ShaderAgreesWithProcessorWhereBufferTexturesAreShort) {
    ASSERT_GT(bins_->leaves.size(), small_limit);
    ASSERT_EQ(texel_storage(small_limit), TexelStorage::rows);
    expect_agreement(ask(small_limit));
}

// Negative control: a leaf that differs by 3e-5 is noticed.
TEST_F(Lookup, DifferenceIsNoticed) {
    const Answers answers = ask(small_limit);
    auto changed = std::make_shared<Snapshot>(*bins_);
    for (glm::vec4& texel : changed->leaves) texel *= 1.00003f;
    bins_ = changed;
    const std::uint32_t u = lookup::fixed_point_of(points_[4].x), v = lookup::fixed_point_of(points_[4].y);
    const float expected = lookup::look_up(*bins_, bins_->charts[4].direct_root, 0u, u, v).value.x;
    EXPECT_GT(std::abs(answers.value[16] - expected), 1e-5f * expected);
}

}  // namespace
}  // namespace brewster
