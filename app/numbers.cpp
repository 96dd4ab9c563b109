#include "app/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/check.h"

namespace brewster {
namespace {

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

}  // namespace

std::optional<std::uint64_t> parse_whole_number(std::string_view text) {
    std::string digits;
    std::size_t fraction_digits = 0;
    std::size_t at = 0;
    bool after_point = false;
    for (; at < text.size() && text[at] != 'e' && text[at] != 'E'; ++at) {
        if (text[at] == '.' && !after_point) {
            after_point = true;
        } else if (is_digit(text[at])) {
            digits += text[at];
            if (after_point) ++fraction_digits;
        } else {
            return std::nullopt;
        }
    }
    if (digits.empty()) return std::nullopt;

    int exponent = 0;
    if (at < text.size()) {
        std::string_view written = text.substr(at + 1);
        if (written.starts_with('+')) written.remove_prefix(1);
        const char* end = written.data() + written.size();
        const auto [stop, failure] = std::from_chars(written.data(), end, exponent);
        if (failure != std::errc{} || stop != end) return std::nullopt;
    }

    while (!digits.empty() && digits.back() == '0' && fraction_digits > 0) {
        digits.pop_back();
        --fraction_digits;
    }
    const std::size_t first = digits.find_first_not_of('0');
    if (first == std::string::npos) return 0;
    const long zeros = static_cast<long>(exponent) - static_cast<long>(fraction_digits);
    if (zeros > std::numeric_limits<std::uint64_t>::digits10) return std::nullopt;
    if (zeros < 0) {
        const auto dropped = static_cast<std::size_t>(-zeros);
        if (dropped >= digits.size() || digits.find_last_not_of('0') >= digits.size() - dropped) return std::nullopt;
        digits.resize(digits.size() - dropped);
    } else {
        digits.append(static_cast<std::size_t>(zeros), '0');
    }

    std::uint64_t value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, failure] = std::from_chars(digits.data(), end, value);
    if (failure != std::errc{} || stop != end) return std::nullopt;
    return value;
}

std::optional<double> parse_number(std::string_view text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    if (failure != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<PictureSize> parse_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const std::optional<std::uint64_t> width = parse_whole_number(text.substr(0, cross));
    const std::optional<std::uint64_t> height = parse_whole_number(text.substr(cross + 1));
    if (!width || !height) return std::nullopt;
    const auto fits = [](std::uint64_t side) { return side >= 1 && side <= largest_picture_side; };
    if (!fits(*width) || !fits(*height)) return std::nullopt;
    return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
}

std::string exact_text(double value) {
    std::array<char, 32> text{};
    const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value);
    BREWSTER_CHECK(failure == std::errc{}, std::to_string(value));
    return {text.data(), end};
}

std::string significant(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string with_error(double value, double error) {
    constexpr int most_decimals = 5;
    const double decimals = std::ceil(-std::log10(error));
    if (!(error > 0) || decimals > most_decimals) return significant(value, error > 0 ? 2 : 3);
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", static_cast<int>(std::max(0.0, decimals)), value);
    return text;
}

std::string with_magnitude(double value) {
    static constexpr struct {
        double scale;
        const char* unit;
    } magnitudes[] = {{1e12, " T"}, {1e9, " G"}, {1e6, " M"}, {1e3, " k"}};
    for (const auto& magnitude : magnitudes) {
        if (value >= magnitude.scale) return significant(value / magnitude.scale, 4) + magnitude.unit;
    }
    return significant(value, 4);
}

}  // namespace brewster
