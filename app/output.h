#pragma once
#include <string_view>

namespace brewster {

/// Writes a result to standard output. Throws Error when it does not arrive (a full disk, a closed pipe).
void print_result(std::string_view text);

}  // namespace brewster
