#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace brewster {

/// The known name that a mistyped one most likely means; none when nothing is near (more than a third of the letters
/// wrong). Capitals count as their small letters; a swap of neighbours is one mistake.
std::optional<std::string> nearest_name(std::string_view mistyped, std::span<const std::string> known);

/// "; did you mean 'front'?", or nothing.
std::string did_you_mean(std::string_view mistyped, std::span<const std::string> known);

}  // namespace brewster
