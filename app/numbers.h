#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace brewster {

/// The whole number that a text such as "120", "2e7" or "1.5e6" stands for, exactly; none for a fraction, a sign, a
/// number of 2^64 or more, or anything else.
std::optional<std::uint64_t> parse_whole_number(std::string_view text);

/// A finite decimal number; the whole text must be one.
std::optional<double> parse_number(std::string_view text);

struct PictureSize {
    int width = 0, height = 0;  ///< pixels

    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

inline constexpr int largest_picture_side = 16384;

/// "640x480": two whole numbers of 1 to largest_picture_side.
std::optional<PictureSize> parse_size(std::string_view text);

/// For people: so many significant digits, without needless zeros ("0.031", "1.2e+09").
std::string significant(double value, int digits = 3);

/// The shortest digits that parse_number reads back as the same number.
std::string exact_text(double value);

/// For people: as many digits as the standard error leaves, three where there is none ("0.27", "-0.0016", "438").
std::string with_error(double value, double error);

/// For people: "12.3 M", "480 k", "7".
std::string with_magnitude(double value);

}  // namespace brewster
