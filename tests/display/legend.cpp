#include "display/legend.h"

#include "display/legend_scale.h"

#include "display/tone.h"
#include "gl_test.h"

namespace brewster {
namespace {

TEST(Legend, LettersFollowTheScreenTheTextAndTheDesktopAsFarAsTheyAreMade) {
    EXPECT_EQ(legend_text_size(800), 17);
    EXPECT_EQ(legend_text_size(300), 12);
    EXPECT_EQ(legend_text_size(800, 2), 34);
    EXPECT_EQ(legend_text_size(1600, 1, 2), 34) << "the same window on a screen of small pixels";
    EXPECT_EQ(legend_text_size(900, 1, 2), 24);
    EXPECT_EQ(legend_text_size(2160, 2, 2), FontAtlas::largest);
}

TEST(Legend, CountsAreBrief) {
    EXPECT_EQ(brief_count(0), "0");
    EXPECT_EQ(brief_count(999), "999");
    EXPECT_EQ(brief_count(1000), "1e3");
    EXPECT_EQ(brief_count(12345), "1.2e4");
    EXPECT_EQ(brief_count(9999999), "1e7");
    EXPECT_EQ(brief_count(20000000000), "2e10");
}

TEST(Legend, ScaleMarksArePowersOfTenWithin) {
    EXPECT_EQ(scale_marks(0.005, 20, 5), (std::vector<double>{0.01, 0.1, 1, 10}));
    EXPECT_EQ(scale_marks(0.1, 10, 5), (std::vector<double>{0.1, 1, 10}));
    EXPECT_EQ(scale_marks(1e-3, 1e3, 4), (std::vector<double>{1e-3, 1e-1, 1e1, 1e3}));
}

TEST(Legend, LabelsDoNotRunIntoEachOther) {
    const std::vector<glm::vec2> places = {{40, 60}, {10, 30}, {25, 39}, {62, 70}, {66, 80}};
    EXPECT_EQ(readable_labels(places, 4), (std::vector<bool>{true, true, false, false, true}));
}

TEST(Legend, AnalyzersAreNamed) {
    EXPECT_EQ(analyzer_words({}), "");
    EXPECT_EQ(analyzer_words({Analyzer::Kind::linear, 22.5}), "analyzer 22.5\u00b0");
    EXPECT_EQ(analyzer_words({Analyzer::Kind::left}), "left circular analyzer");
}

class LegendTest : public GlTest {
  protected:
    ScreenImage drawn(int width, int height, float exposure) {
        const Screen screen = Screen::off_screen(width, height);
        screen.bind();
        screen.clear();
        Text text;
        Rendition rendition;
        rendition.exposure = exposure;
        draw_legend(text, screen, {rendition, "cornell-box", "front", 10000000});
        return screen.read();
    }

    static int lit_pixels(const ScreenImage& image, int left, int top, int width, int height) {
        int count = 0;
        for (int y = top; y < top + height; ++y) {
            for (int x = left; x < left + width; ++x) {
                count += image.rgba[static_cast<std::size_t>(4 * (image.width * y + x))] > 100;
            }
        }
        return count;
    }
};

TEST_F(LegendTest, StandsInTheLowerLeftCorner) {
    const ScreenImage image = drawn(640, 480, 1.3f);
    EXPECT_GT(lit_pixels(image, 0, 360, 260, 120), 1000);
    EXPECT_EQ(lit_pixels(image, 260, 0, 380, 480), 0);
    EXPECT_EQ(lit_pixels(image, 0, 0, 640, 340), 0);
}

TEST_F(LegendTest, IsLeftOutWhereItDoesNotFit) {
    EXPECT_EQ(lit_pixels(drawn(96, 96, 0), 0, 0, 96, 96), 0);
}

// The strip rises from black to white, and it is the tone curve's: its colours do not change with the exposure, the
// radiances written below them do.
TEST_F(LegendTest, StripHasTheColoursOfTheToneCurve) {
    const ScreenImage image = drawn(640, 480, 0);
    int strip = 0, longest = 0;
    for (int y = 360; y < 480; ++y) {  // the row with the longest run of rising greys is in the strip
        int run = 1;
        for (int x = 1; x < 640; ++x) {
            const auto at = [&](int column) { return image.rgba[static_cast<std::size_t>(4 * (640 * y + column))]; };
            run = at(x) >= at(x - 1) && at(x) > 0 ? run + 1 : 1;
            if (run > longest) {
                longest = run;
                strip = y;
            }
        }
    }
    EXPECT_GE(longest, 12 * 14);
    EXPECT_GT(strip, 400);
}

}  // namespace
}  // namespace brewster
