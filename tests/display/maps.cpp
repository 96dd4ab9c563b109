#include "display/maps.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "display/gathered_light.h"
#include "display/legend_scale.h"
#include "display/map_colours.h"
#include "display/screen_pass.h"
#include "display/tone.h"
#include "gl_test.h"
#include "optics/stokes.h"

namespace brewster {
namespace {

TEST(Maps, TablesAndEnumsAgree) {
    for (const MapDescription& entry : map_descriptions) {
        EXPECT_EQ(description(entry.map).name, entry.name);
        EXPECT_EQ(find_map(entry.name), entry.map);
    }
    EXPECT_FALSE(find_map("no such map"));
    for (const PaletteDescription& entry : palette_descriptions) {
        EXPECT_EQ(palette_name(entry.palette), entry.name);
        EXPECT_EQ(find_palette(entry.name), entry.palette);
    }
    EXPECT_FALSE(find_palette("rainbow"));
}

/// Realizable light of any state, brightness over four decades.
glm::vec4 random_light(std::mt19937& random) {
    const auto uniform = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    const glm::vec3 state(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    const float s0 = std::pow(10.0f, uniform(-3, 1));
    const glm::vec3 polarized = s0 * state / std::max(1.0f, glm::length(state));
    return {s0, polarized.x, polarized.y, polarized.z};
}

const glm::vec3 no_noise(0.0f);

// renderer/optics is the oracle of the shared formulas.
TEST(SharedStokes, DegreesAndAnglesAreThoseOfOptics) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec4 light = random_light(random);
        const Stokes<double, 4> exact{{light.x, light.y, light.z, light.w}};
        EXPECT_NEAR(maps::polarization_degree(light, no_noise), std::min(dop(exact), 1.0), 1e-6);
        EXPECT_NEAR(maps::linear_degree(light, no_noise), std::min(dolp(exact), 1.0), 1e-6);
        EXPECT_NEAR(maps::circular_degree(light, no_noise), docp(exact), 1e-6);
        const double half_turn = 0.5 * std::atan2(exact.s2(), exact.s1()) / pi;
        const double difference = static_cast<double>(maps::half_turns(light)) - half_turn;
        EXPECT_NEAR(difference, std::round(difference), 1e-6);
    }
    EXPECT_EQ(maps::polarization_degree(glm::vec4(0.0f), no_noise), 0.0f);
    EXPECT_EQ(maps::linear_degree({0, 1, 0, 0}, no_noise), 0.0f) << "the dark is not polarized";
}

glm::vec4 behind(const Analyzer& analyzer, const glm::vec4& light) {
    return maps::analysed(light, analyzer.passing());
}

TEST(SharedStokes, AnalyzersFollowMalus) {
    using Kind = Analyzer::Kind;
    for (const double light_angle : {0.0, 20.0, 75.0, 130.0}) {
        const auto c = static_cast<float>(std::cos(radians(2 * light_angle)));
        const auto s = static_cast<float>(std::sin(radians(2 * light_angle)));
        for (const double angle : {-30.0, 0.0, 20.0, 90.0, 165.0}) {
            const glm::vec4 passed = behind({Kind::linear, angle}, {3, 3 * c, 3 * s, 0});
            const double malus = 3 * std::pow(std::cos(radians(angle - light_angle)), 2);
            EXPECT_NEAR(passed.x, malus, 1e-6);
            EXPECT_NEAR(passed.y, malus * std::cos(radians(2 * angle)), 1e-6);
            EXPECT_NEAR(passed.z, malus * std::sin(radians(2 * angle)), 1e-6);
        }
        EXPECT_NEAR(behind({Kind::right}, {3, 3 * c, 3 * s, 0}).x, 1.5f, 1e-6f);
    }
    EXPECT_EQ(behind({Kind::right}, {2, 0, 0, 2}), glm::vec4(2, 0, 0, 2));
    EXPECT_EQ(behind({Kind::left}, {2, 0, 0, 2}).x, 0.0f);
    EXPECT_EQ(behind({Kind::linear, 45}, {2, 0, 0, 0}).x, 1.0f) << "half of what is unpolarized";
    EXPECT_EQ(behind({}, {2, 1, 0.5f, 0.25f}), glm::vec4(2, 1, 0.5f, 0.25f));
}

// Unpolarized light with Gaussian noise of 1 to 20 % of S0 in each component: beyond 4 standard errors are
// exp(-8) = 3e-4 of lengths of two, 1e-3 of lengths of three and 6e-5 of single components. Without the floor every
// pixel would show some. Light of 30 % with 2 % of noise keeps its square: E(|p|^2) - noise = 0.09, spread over 20000
// pixels 2 * 0.3 * 0.02 / sqrt(20000) = 1e-4.
TEST(SharedStokes, NoiseIsNotShownAsPolarization) {
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    constexpr int pixels = 20000;
    for (const float error : {0.01f, 0.05f, 0.2f}) {
        const glm::vec3 noise(error * error);
        int any = 0, linear = 0, circular = 0;
        double squares = 0;
        for (int i = 0; i < pixels; ++i) {
            const glm::vec4 light(1.0f, error * normal(random), error * normal(random), error * normal(random));
            any += maps::polarization_degree(light, noise) > 0;
            linear += maps::linear_degree(light, noise) > 0;
            circular += maps::circular_degree(light, noise) > 0;
            const glm::vec4 polarized(1.0f, 0.3f + 0.02f * normal(random), 0.02f * normal(random), 0.0f);
            squares += std::pow(maps::linear_degree(polarized, glm::vec3(4e-4f)), 2) / pixels;
        }
        EXPECT_LT(linear, pixels * 1e-3);
        EXPECT_LT(any, pixels * 3e-3);
        EXPECT_LT(circular, pixels * 5e-4);
        EXPECT_NEAR(squares, 0.09, 5e-4);
    }
}

TEST(SharedStokes, ErrorsAreShownByTheirLogarithm) {
    EXPECT_NEAR(maps::error_level(2.0f, 4.0f), 1.0f, 1e-6f);
    EXPECT_NEAR(maps::error_level(2.0f, 4e-2f), 2.0f / 3, 1e-6f);
    EXPECT_NEAR(maps::error_level(2.0f, 4e-6f), 0.0f, 1e-6f);
    EXPECT_EQ(maps::error_level(1.0f, 0.0f), 0.0f);
    EXPECT_EQ(maps::error_level(1.0f, 9.0f), 1.0f);
    EXPECT_LT(maps::error_level(0.0f, 1.0f), 0.0f);
}

glm::vec3 linear_light(glm::vec3 code) {
    const auto band = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return {band(code.x), band(code.y), band(code.z)};
}

/// What a deuteranope and a protanope tell apart: two numbers that stand for lightness and for blue against yellow, of
/// sRGB light by F. Vienot, H. Brettel, J. Mollon, "Digital video colourmaps for checking the legibility of displays by
/// dichromats" (1999): red and green act by one weighted sum.
glm::vec2 dichromat(glm::vec3 code, float red_weight) {
    const glm::vec3 light = linear_light(code);
    const float yellow = red_weight * light.x + (1 - red_weight) * light.y;
    return {std::cbrt(yellow), std::cbrt(light.z)};
}

constexpr std::array red_weights = {0.29275f, 0.11238f};  ///< deuteranope, protanope

TEST(BlueOrange, IsLegibleToTheColourBlind) {
    const int palette = BREWSTER_BLUE_ORANGE;
    for (const float weight : red_weights) {
        const auto apart = [&](glm::vec3 a, glm::vec3 b) {
            return glm::distance(dichromat(a, weight), dichromat(b, weight));
        };
        for (const float level : {0.3f, 0.6f, 1.0f})
            EXPECT_GT(apart(maps::signed_colour(palette, level), maps::signed_colour(palette, -level)), 0.2f * level);
        float before = -1;
        for (int k = 0; k <= 20; ++k) {
            const float lightness = dichromat(maps::degree_colour(palette, static_cast<float>(k) / 20), weight).x;
            EXPECT_GT(lightness, before) << k;
            before = lightness;
        }
        for (int k = 0; k < 36; ++k) {
            const float place = static_cast<float>(k) / 36;
            EXPECT_GT(apart(maps::angle_colour(palette, place), maps::angle_colour(palette, place + 0.5f)), 0.3f) << k;
        }
        EXPECT_GT(apart(maps::type_colour(palette, 1, 1), maps::type_colour(palette, -1, 1)), 0.3f);
    }
    // The control: plain hues of directions that are crossed, and red against green, look much more alike.
    float least = 1;
    for (int k = 0; k < 36; ++k) {
        const float place = static_cast<float>(k) / 36;
        least = std::min(least, glm::distance(dichromat(maps::hue_colour(place), red_weights[0]),
                                              dichromat(maps::hue_colour(place + 0.5f), red_weights[0])));
    }
    EXPECT_LT(least, 0.3f);
}

// Hue is twice the angle in every palette: the greatest band and the middle one keep their places.
TEST(Palettes, HueIsTwiceTheAngle) {
    for (const int palette : {BREWSTER_BLUE_ORANGE, BREWSTER_RED_GREEN, BREWSTER_POLANALYSER}) {
        for (int degrees = 0; degrees < 180; degrees += 10) {
            const glm::vec3 c = maps::angle_colour(palette, static_cast<float>(degrees) / 180);
            const float low = std::min({c.x, c.y, c.z}), high = std::max({c.x, c.y, c.z});
            float hue = c.x == high   ? (c.y - c.z)
                        : c.y == high ? 2 * (high - low) + c.z - c.x
                                      : 4 * (high - low) + c.x - c.y;
            hue = 60 * hue / (high - low);
            EXPECT_NEAR(std::remainder(hue - 2.0f * static_cast<float>(degrees), 360.0f), 0.0f, 1e-2f);
        }
    }
}

TEST(Palettes, SignsHaveTheColoursOfTheirSources) {
    EXPECT_EQ(maps::signed_colour(BREWSTER_RED_GREEN, 1), glm::vec3(0, 1, 0));
    EXPECT_EQ(maps::signed_colour(BREWSTER_RED_GREEN, -1), glm::vec3(1, 0, 0));
    EXPECT_EQ(maps::signed_colour(BREWSTER_POLANALYSER, 1), glm::vec3(1, 0, 0));
    EXPECT_EQ(maps::signed_colour(BREWSTER_POLANALYSER, 0), glm::vec3(1, 1, 1));
    EXPECT_EQ(maps::type_colour(BREWSTER_RED_GREEN, 0, 1), glm::vec3(0, 1, 1));
    EXPECT_EQ(maps::type_colour(BREWSTER_RED_GREEN, 1, 1), glm::vec3(1, 1, 0));
}

/// The maps once more, from the shared formulas: what shaders/maps.glsl must show for a pixel.
struct Pixel {
    std::array<glm::vec4, 3> light;  ///< by band
    std::array<glm::vec3, 3> noise;
    glm::vec3 unpolarized, unpolarized_variance;
};

glm::vec3 expected_colour(Pixel pixel, const Rendition& rendition) {
    const int palette = static_cast<int>(rendition.palette);
    if (!rendition.shows_polarized_world()) {
        for (int band = 0; band < 3; ++band) {
            pixel.light[static_cast<std::size_t>(band)] = {pixel.unpolarized[band], 0, 0, 0};
            pixel.noise[static_cast<std::size_t>(band)] = {pixel.unpolarized_variance[band], 0, 0};
        }
    }
    glm::vec4 mean(0.0f);
    glm::vec3 errors(0.0f), radiance;
    for (std::size_t band = 0; band < 3; ++band) {
        const glm::vec4 passed = behind(rendition.analyzer, pixel.light[band]);
        radiance[static_cast<int>(band)] = passed.x;
        mean += passed / 3.0f;
        errors += glm::sqrt(maps::analysed_noise(pixel.noise[band], rendition.analyzer.passing())) / 3.0f;
    }
    const glm::vec3 noise = errors * errors;
    const auto signed_colour = [&](float value) {
        const float level = tone::srgb_code(tone::shoulder(std::abs(value) * std::exp2(rendition.exposure)));
        return maps::signed_colour(palette, std::copysign(level, value));
    };
    const float degree = maps::polarization_degree(mean, noise);
    const bool filtered = rendition.analyzer.kind != Analyzer::Kind::none;
    switch (rendition.map) {
        case Map::radiance:
            return tone::screen_colour(radiance, rendition.exposure);
        case Map::s1:
            return signed_colour(mean.y);
        case Map::s2:
            return signed_colour(mean.z);
        case Map::s3:
            return signed_colour(mean.w);
        case Map::dop:
            return maps::degree_colour(palette, degree);
        case Map::dolp:
            return maps::degree_colour(palette, maps::linear_degree(mean, noise));
        case Map::docp:
            return maps::degree_colour(palette, maps::circular_degree(mean, noise));
        case Map::aolp:
            return maps::linear_degree(mean, noise) > 0 ? maps::angle_colour(palette, maps::half_turns(mean))
                                                        : maps::masked_colour();
        case Map::type:
            return degree > 0 ? maps::type_colour(palette, maps::roundness(mean), tone::srgb_code(degree))
                              : maps::masked_colour();
        case Map::difference: {
            const glm::vec3 u = pixel.unpolarized;
            return signed_colour(mean.x - (filtered ? 0.5f : 1.0f) * (u.x + u.y + u.z) / 3.0f);
        }
        case Map::error:
            return maps::degree_colour(palette, maps::error_level(mean.x, noise.x));
        case Map::bins:
            break;
    }
    return glm::vec3(0.0f);
}

class MapsTest : public GlTest {
  protected:
    static constexpr int side = 100;  ///< 1e4 pixels

    MapsTest() : picture_(side, side) {
        std::mt19937 random(3);
        const auto uniform = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
        for (std::size_t i = 0; i < picture_.pixel_count(); ++i) {
            const float error = std::pow(10.0f, uniform(-3, 0));
            for (int band = 0; band < 3; ++band) {
                const glm::vec4 light = random_light(random);
                for (int k = 0; k < 4; ++k) {
                    picture_.light[static_cast<std::size_t>(k)][i][band] = light[k];
                    const float own = error * light.x * uniform(0.5f, 1.5f);
                    picture_.variance[static_cast<std::size_t>(k)][i][band] = own * own;
                }
                picture_.of(Plane::unpolarized)[i][band] = light.x * uniform(0.5f, 1.5f);
                picture_.variance_of(Plane::unpolarized)[i][band] = error * light.x * light.x;
            }
        }
        light_.upload(picture_);
    }

    Pixel pixel(std::size_t i) const {
        Pixel pixel;
        for (int band = 0; band < 3; ++band) {
            const auto value = [&](Plane plane) { return picture_.of(plane)[i][band]; };
            const auto variance = [&](Plane plane) { return picture_.variance_of(plane)[i][band]; };
            pixel.light[static_cast<std::size_t>(band)] = {value(Plane::s0), value(Plane::s1), value(Plane::s2),
                                                           value(Plane::s3)};
            pixel.noise[static_cast<std::size_t>(band)] = {
                variance(Plane::s0), std::max(variance(Plane::s1), variance(Plane::s2)), variance(Plane::s3)};
        }
        pixel.unpolarized = picture_.of(Plane::unpolarized)[i];
        pixel.unpolarized_variance = picture_.variance_of(Plane::unpolarized)[i];
        return pixel;
    }

    ScreenImage shown(const Rendition& rendition) const {
        const Screen screen = Screen::off_screen(side, side);
        pass_.show(screen, light_.textures(), rendition);
        return screen.read();
    }

    StokesPicture picture_;
    GatheredLight light_;
    ScreenPass pass_;
};

// Rounding to eight bits and the driver's pow move a code by one, its log2 by two. A degree at the floor of its noise, and
// an angle next to the seam of two hues, may fall on either side: fewer than one in a thousand.
TEST_F(MapsTest, ShaderAndProcessorAgree) {
    using Kind = Analyzer::Kind;
    const std::array analyzers = {Analyzer{}, Analyzer{Kind::linear, 30}, Analyzer{Kind::right}, Analyzer{Kind::left}};
    for (const MapDescription& entry : map_descriptions) {
        if (entry.map == Map::bins) continue;
        for (std::size_t k = 0; k < 12; ++k) {
            Rendition rendition;
            rendition.map = entry.map;
            rendition.palette = palette_descriptions[k % 3].palette;
            rendition.analyzer = analyzers[k % 4];
            rendition.polarization = k < 8;
            rendition.exposure = -1.5f;
            const ScreenImage screen = shown(rendition);
            int wrong = 0;
            for (std::size_t i = 0; i < picture_.pixel_count(); ++i) {
                const glm::vec3 expected = expected_colour(pixel(i), rendition);
                for (int band = 0; band < 3; ++band) {
                    const auto code = static_cast<float>(screen.rgba[4 * i + static_cast<std::size_t>(band)]);
                    wrong += std::abs(code - 255 * expected[band]) > (entry.map == Map::error ? 2.01f : 1.01f);
                }
            }
            EXPECT_LE(wrong, 3 * side * side / 1000)
                << entry.name << ' ' << palette_name(rendition.palette) << " analyzer " << k % 4;
        }
    }
}

// Where nothing has come yet, what is there stays.
TEST_F(MapsTest, APictureComesTileByTileOverAnother) {
    Rendition dolp;
    dolp.map = Map::dolp;
    const ScreenImage whole = shown(dolp);
    StokesPicture other = picture_;
    for (glm::vec3& pixel : other.of(Plane::s1)) pixel = -0.5f * pixel;
    GatheredLight below;
    below.upload(other);
    const Screen screen = Screen::off_screen(side, side);
    const auto shown_over = [&] {
        pass_.show(screen, below.textures(), dolp);
        pass_.show(screen, light_.textures(), dolp, true);
        return screen.read();
    };
    light_.clear();
    while (!light_.make_room(side, side)) continue;
    const ScreenImage before = shown_over();
    ASSERT_NE(before.rgba, whole.rgba);
    const auto cut_out = [&](int left, int top, int width, int height) {
        StokesPicture part(width, height);
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < width; ++column) {
                const auto to = static_cast<std::size_t>(row * width + column),
                           from = static_cast<std::size_t>((top + row) * side + left + column);
                for (std::size_t plane = 0; plane < plane_count; ++plane) {
                    part.light[plane][to] = picture_.light[plane][from];
                    part.variance[plane][to] = picture_.variance[plane][from];
                }
            }
        light_.put(part, left, top);
    };
    cut_out(3, 5, 20, 10);
    const ScreenImage one = shown_over();
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const bool inside = column >= 3 && column < 23 && row >= 5 && row < 15;
            const auto i = 4 * static_cast<std::size_t>(row * side + column);
            const auto& expected = inside ? whole.rgba : before.rgba;
            ASSERT_TRUE(std::equal(&one.rgba[i], &one.rgba[i] + 4, &expected[i])) << column << ' ' << row;
        }
    cut_out(0, 0, side, 5);
    cut_out(0, 5, side, side - 5);
    EXPECT_EQ(shown_over().rgba, whole.rgba);
}

TEST_F(MapsTest, WorldsAreChosenByTheRendition) {
    Rendition rendition;
    const ScreenImage on = shown(rendition);
    rendition.polarization = false;
    EXPECT_NE(on.rgba, shown(rendition).rgba);
    rendition.map = Map::dop;
    const ScreenImage off = shown(rendition);
    const glm::vec3 black = 255.0f * maps::degree_colour(BREWSTER_BLUE_ORANGE, 0);
    for (std::size_t i = 0; i < picture_.pixel_count(); ++i)
        ASSERT_EQ(static_cast<float>(off.rgba[4 * i]), black.x) << "nothing is polarized there";
}

// A mark stands where the map shows its value in the colour above it.
TEST_F(MapsTest, MarksOfTheLegendStandUnderTheirColours) {
    for (const MapDescription& entry : map_descriptions) {
        if (entry.scale != Scale::signed_radiance && entry.scale != Scale::radiance) continue;
        Rendition rendition;
        rendition.map = entry.map;
        rendition.exposure = 2.3f;
        const LegendScale scale = legend_scale(rendition);
        EXPECT_GE(scale.marks.size(), 3u);
        for (const ScaleMark& mark : scale.marks) {
            const bool negative = mark.label.starts_with("\u2212");
            const float value = (negative ? -1.0f : 1.0f) * std::stof(negative ? mark.label.substr(3) : mark.label);
            Pixel pixel{};
            pixel.light.fill(glm::vec4(entry.map == Map::difference ? value : std::abs(value), value, value, value));
            const glm::vec3 difference =
                scale.colour(static_cast<float>(mark.place), 1) - expected_colour(pixel, rendition);
            EXPECT_LT(glm::length(difference), 1e-3f) << entry.name << ' ' << mark.label;
        }
    }
}

}  // namespace
}  // namespace brewster
