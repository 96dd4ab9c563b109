#pragma once
#include <string>
#include <string_view>

namespace brewster {

/// Percent-encoded bytes decoded; a percent sign without two hexadecimal digits stands for itself.
std::string decoded_uri(std::string_view uri);

/// Whether a URI of a glTF file is data, or a relative path that only goes down: no scheme, no drive, not from the root,
/// no "..", no zero byte, before or after decoding. Links are followed and judged where files are opened.
bool stays_below(std::string_view uri);

}  // namespace brewster
