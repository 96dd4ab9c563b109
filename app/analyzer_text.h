#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "display/rendition.h"

namespace brewster {

/// "none", "right", "left", or an angle in degrees such as "30" or "-12.5"; none for anything else.
std::optional<Analyzer> parse_analyzer(std::string_view text);

/// What parse_analyzer reads, to the last digit.
std::string analyzer_text(const Analyzer& analyzer);

}  // namespace brewster
