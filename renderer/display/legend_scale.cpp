#include "display/legend_scale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "display/map_colours.h"
#include "display/tone.h"

namespace brewster {
namespace {

std::string number(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%g", value);
    return digits;
}

std::string with_sign(double value) {
    return value < 0 ? "\u2212" + number(-value) : number(value);
}

LegendScale radiance_scale(float exposure) {
    // The strip runs over what the curve and eight bits tell apart, in exposed units.
    constexpr double darkest = 0.0025, brightest = 32.0;
    const double scale = std::exp2(-static_cast<double>(exposure));
    const double low = darkest * scale, ratio = brightest / darkest;
    LegendScale strip;
    strip.colour = [=](float place, float) {
        const double radiance = low * std::pow(ratio, static_cast<double>(place));
        return tone::screen_colour(glm::vec3(static_cast<float>(radiance)), exposure);
    };
    for (const double mark : scale_marks(low, low * ratio, 5))
        strip.marks.push_back({std::log(mark / low) / std::log(ratio), number(mark)});
    return strip;
}

/// Colours run evenly; marks stand where the tone curve puts their value.
LegendScale signed_scale(int palette, float exposure) {
    // Exposed units whose marks stand neither on the zero nor on the ends.
    constexpr double least = 0.08, most = 5.0;
    const double scale = std::exp2(-static_cast<double>(exposure));
    LegendScale strip;
    strip.colour = [=](float place, float) { return maps::signed_colour(palette, 2 * place - 1); };
    strip.marks.push_back({0.5, "0"});
    for (const double mark : scale_marks(least * scale, most * scale, 2)) {
        const double level = static_cast<double>(tone::srgb_code(tone::shoulder(static_cast<float>(mark / scale))));
        strip.marks.push_back({0.5 - 0.5 * level, with_sign(-mark)});
        strip.marks.push_back({0.5 + 0.5 * level, number(mark)});
    }
    return strip;
}

LegendScale even_scale(std::function<glm::vec3(float, float)> colour, std::vector<std::string> labels) {
    LegendScale strip;
    strip.colour = std::move(colour);
    for (std::size_t k = 0; k < labels.size(); ++k)
        strip.marks.push_back({static_cast<double>(k) / static_cast<double>(labels.size() - 1), labels[k]});
    return strip;
}

}  // namespace

std::vector<double> scale_marks(double low, double high, int most) {
    std::vector<double> marks;
    const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
    const int step = std::max(1, (last - first + most) / most);
    for (int power = first; power <= last; power += step) marks.push_back(std::pow(10.0, power));
    return marks;
}

std::vector<bool> readable_labels(const std::vector<glm::vec2>& places, float gap) {
    std::vector<bool> readable(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        readable[k] = true;
        for (std::size_t i = 0; i < k; ++i)
            if (readable[i] && places[k].x < places[i].y + gap && places[i].x < places[k].y + gap) readable[k] = false;
    }
    return readable;
}

LegendScale legend_scale(const Rendition& rendition) {
    const int palette = static_cast<int>(rendition.palette);
    const auto degree = [palette](float place, float) { return maps::degree_colour(palette, place); };
    switch (description(rendition.map).scale) {
        case Scale::radiance:
            return radiance_scale(rendition.exposure);
        case Scale::signed_radiance:
            return signed_scale(palette, rendition.exposure);
        case Scale::degree:
            return even_scale(degree, {"0", "25", "50", "75", "100"});
        case Scale::relative_error:
            return even_scale(degree, {"0.1", "1", "10", "100"});
        case Scale::angle:
            return even_scale([palette](float place, float) { return maps::angle_colour(palette, place - 0.5f); },
                              {"\u221290", "\u221245", "0", "45", "90"});
        case Scale::type: {
            LegendScale strip = even_scale(
                [palette](float place, float height) {
                    return maps::type_colour(palette, 2 * place - 1, tone::srgb_code(height));
                },
                {"left", "linear", "right"});
            strip.two_values = true;
            return strip;
        }
        case Scale::none:
            break;
    }
    return {};
}

}  // namespace brewster
