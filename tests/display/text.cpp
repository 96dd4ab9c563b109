#include "display/text.h"

#include "gl_test.h"

namespace brewster {
namespace {

TEST(CodePoints, Utf8IsDecodedAndBrokenBytesAreMarked) {
    EXPECT_EQ(code_points("a\u00b0\u2212\U0001f600"), (std::vector<char32_t>{U'a', 0xb0, 0x2212, 0x1f600}));
    EXPECT_EQ(code_points("\xb0z"), (std::vector<char32_t>{0xfffd, U'z'}));  // a tail without its head
    EXPECT_EQ(code_points("\xe2\x88"), (std::vector<char32_t>{0xfffd}));     // cut off
    EXPECT_EQ(code_points("\xc3x"), (std::vector<char32_t>{0xfffd, U'x'}));  // tail missing
    EXPECT_TRUE(code_points("").empty());
}

TEST(FontAtlas, EverySizeFitsAndMeasures) {
    for (const int size : {6, 12, 20, 48}) {
        const FontAtlas atlas(size);
        EXPECT_GT(atlas.width("WW"), atlas.width("ii"));
        EXPECT_NEAR(atlas.width("ab"), atlas.width("a") + atlas.width("b"), 1e-4f);
        EXPECT_GT(atlas.ascent(), 0.6f * static_cast<float>(size));
        EXPECT_LT(atlas.ascent(), static_cast<float>(size));
    }
}

TEST(FontAtlas, UnknownSignsAreQuestionMarks) {
    const FontAtlas atlas(16);
    EXPECT_EQ(&atlas.glyph(0x4e00), &atlas.glyph(U'?'));
    EXPECT_NE(&atlas.glyph(0xb0), &atlas.glyph(U'?'));
}

class TextTest : public GlTest {
  protected:
    TextTest() : screen_(Screen::off_screen(200, 60)) {
        screen_.bind();
        screen_.clear();
    }

    /// Sum of the red codes in a rectangle.
    int ink(int left, int top, int width, int height) const {
        const ScreenImage image = screen_.read();
        int sum = 0;
        for (int y = top; y < top + height; ++y) {
            for (int x = left; x < left + width; ++x) sum += image.rgba[static_cast<std::size_t>(4 * (200 * y + x))];
        }
        return sum;
    }

    Screen screen_;
    Text text_;
};

TEST_F(TextTest, StandsWhereItIsPut) {
    text_.add("Brewster 56.3\u00b0", {20, 10}, 20, glm::vec4(1.0f));
    text_.draw(screen_);
    const int width = static_cast<int>(text_.width("Brewster 56.3\u00b0", 20));
    EXPECT_GT(ink(20, 10, width, 20), 255 * 100);
    EXPECT_EQ(ink(0, 0, 200, 60), ink(19, 10, width + 2, 20));
    text_.draw(screen_);  // nothing is left to draw
    EXPECT_EQ(ink(0, 40, 200, 20), 0);
}

TEST_F(TextTest, SmallTextKeepsFullStrokes) {
    text_.add("lllll", {10, 10}, 12, glm::vec4(1.0f));
    text_.draw(screen_);
    int brightest = 0;
    const ScreenImage image = screen_.read();
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) brightest = std::max<int>(brightest, image.rgba[i]);
    EXPECT_GT(brightest, 180);
}

TEST_F(TextTest, LabelIsReadableOnWhite) {
    text_.add_rectangle({0, 0}, {200, 60}, glm::vec4(1.0f));
    text_.draw(screen_);
    EXPECT_EQ(ink(0, 0, 200, 60), 255 * 200 * 60);
    text_.add_label("label", {10, 10}, 16);
    text_.draw(screen_);
    const ScreenImage image = screen_.read();
    EXPECT_EQ(image.rgba[4 * (200 * 12 + 12)], 102);  // 40 % of white behind the text
    EXPECT_EQ(image.rgba[4 * (200 * 5 + 5)], 255);
    EXPECT_EQ(image.rgba[4 * (200 * 12 + 12) + 3], 255);
}

TEST_F(TextTest, SizesMayMix) {
    text_.add("small", {5, 5}, 10, glm::vec4(1.0f));
    text_.add("large", {60, 5}, 40, glm::vec4(1.0f));
    text_.draw(screen_);
    EXPECT_GT(ink(5, 5, 50, 10), 2000);
    EXPECT_GT(ink(60, 5, 140, 40), 20000);
}

}  // namespace
}  // namespace brewster
