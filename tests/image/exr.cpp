#include "image/exr.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "base/error.h"
#include "temporary_folder.h"

namespace brewster {
namespace {

Image stokes_picture() {
    Image image(9, 4);
    float value = 1e-6f;
    for (int component = 0; component < 4; ++component) {
        for (int band = 0; band < 3; ++band) {
            for (float& x : image.add_channel(stokes_channel(component, band))) x = value *= 1.09f;
            for (float& x : image.add_channel(variance_channel(component, band))) x = 1e-3f * value;
        }
    }
    return image;
}

std::string attribute(const Image& image, const std::string& name) {
    for (const auto& [key, text] : image.attributes) {
        if (key == name) return text;
    }
    return "missing";
}

TEST(Exr, FloatRoundTripIsExact) {
    const TemporaryFolder folder;
    Image image = stokes_picture();
    image.attributes.emplace_back("brewster.note", "kept");
    write_exr(folder.file("a.exr"), image);
    const Image again = read_exr(folder.file("a.exr"));
    ASSERT_EQ(again.width(), 9);
    ASSERT_EQ(again.height(), 4);
    ASSERT_EQ(again.channel_names().size(), image.channel_names().size());
    for (const std::string& name : image.channel_names()) EXPECT_EQ(again.channel(name), image.channel(name)) << name;
    EXPECT_EQ(attribute(again, "brewster.note"), "kept");
}

TEST(Exr, HalfRoundTripKeepsElevenBits) {
    const TemporaryFolder folder;
    Image image(64, 1);
    std::vector<float>& values = image.add_channel("S0.R");
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1e-3f * std::pow(1.2f, static_cast<float>(i));
    write_exr(folder.file("a.exr"), image, ExrPrecision::half);
    const Image again = read_exr(folder.file("a.exr"));
    int rounded = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(again.channel("S0.R")[i], values[i], values[i] * 0x1p-11f);
        rounded += again.channel("S0.R")[i] != values[i];
    }
    EXPECT_GT(rounded, 32);  // or it was not half at all
}

// Smaller than any half, and larger.
TEST(Exr, HalfPicturesKeepVariancesAndWhatIsTooBright) {
    const TemporaryFolder folder;
    Image image(64, 1);
    for (const char* name : {"V0.R", "S0.R"}) image.add_channel(name);
    std::vector<float>&variances = image.channel("V0.R"), &bright = image.channel("S0.R");
    for (std::size_t i = 0; i < variances.size(); ++i) variances[i] = 1e-14f * std::pow(1.7f, static_cast<float>(i));
    bright[5] = 65600.0f;
    bright[6] = 1.0001f;
    write_exr(folder.file("a.exr"), image, ExrPrecision::half);
    const Image again = read_exr(folder.file("a.exr"));
    EXPECT_EQ(again.channel("S0.R"), bright);
    for (std::size_t i = 0; i < variances.size(); ++i)
        EXPECT_NEAR(again.channel("V0.R")[i], variances[i], variances[i] * 0x1p-5f);
    EXPECT_NE(again.channel("V0.R"), variances);
}

TEST(Exr, StokesPictureNamesItsConventionsAndShowsItsRadiance) {
    const TemporaryFolder folder;
    write_stokes_exr(folder.file("a.exr"), stokes_picture());
    const Image again = read_exr(folder.file("a.exr"));
    EXPECT_EQ(again.channel_names().size(), 27u);
    EXPECT_EQ(again.channel("R"), again.channel("S0.R"));
    EXPECT_EQ(again.channel("G"), again.channel("S0.G"));
    EXPECT_EQ(again.channel("B"), again.channel("S0.B"));
    EXPECT_EQ(attribute(again, "brewster.frame"), "x = normalize(cross(ray, up)), receiver");
    EXPECT_EQ(attribute(again, "brewster.s3"), "right circular positive");
}

// The peer's own record of the means: an independent reader wrote them.
TEST(Exr, ReadsThePicturesOfAnotherRenderer) {
    const std::string folder = BREWSTER_SOURCE_DIR "/tests/images/peer/";
    const Image front = read_exr(folder + "cornell-box-front.exr");
    ASSERT_EQ(front.width(), 96);
    ASSERT_EQ(front.height(), 96);
    constexpr std::array means = {0.18651754216, 0.12320591215, 0.03612805809};
    for (int band = 0; band < 3; ++band) {
        const std::vector<float>& s0 = front.channel(stokes_channel(0, band));
        const double mean = std::accumulate(s0.begin(), s0.end(), 0.0) / static_cast<double>(s0.size());
        EXPECT_NEAR(mean, means[static_cast<std::size_t>(band)], 1e-7);
        EXPECT_TRUE(front.has(variance_channel(3, band)));
    }
    for (const char* name : {"inside", "low"}) {
        EXPECT_EQ(read_exr(folder + "cornell-box-" + name + ".exr").channel_names().size(), 27u);
    }
}

TEST(Exr, SaysWhatIsWrong) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_exr(folder.file("missing.exr")), Error);
    std::ofstream(folder.file("text.exr")) << "not a picture";
    EXPECT_THROW(read_exr(folder.file("text.exr")), Error);
    EXPECT_THROW(write_exr(folder.file("no/such/folder.exr"), stokes_picture()), Error);

    write_exr(folder.file("cut.exr"), stokes_picture());
    std::filesystem::resize_file(folder.file("cut.exr"), std::filesystem::file_size(folder.file("cut.exr")) - 40);
    EXPECT_THROW(read_exr(folder.file("cut.exr")), Error);
}

}  // namespace
}  // namespace brewster
