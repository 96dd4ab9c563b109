#pragma once
#include <string_view>

namespace brewster {

/// Messages for people go to standard error; standard output belongs to results.
void log_info(std::string_view message);
void log_warning(std::string_view message);

/// Hides everything below warnings (`--json` runs and tests).
void log_only_warnings();

}  // namespace brewster
