#pragma once
#include <string>
#include <string_view>

namespace brewster {

/// Units in a text as people write them: "cd/m2" with its square, "um" with its mu, "degrees" with its sign.
std::string with_unit_signs(std::string text);

/// A setting's name in words, with its unit: "rmsHeight", "um": "rms height, \u00b5m".
std::string setting_label(std::string_view name, std::string_view unit);

/// What a map is called, without what its legend says of its colours: "S1", "degree of polarization".
std::string map_label(std::string_view title);

/// A line of less weight, as many lines as it takes.
void faint_text(const char* text);

/// Says so while the pointer is over the widget that was made last.
void hint(const char* text);

}  // namespace brewster
