#pragma once
#include <string>
#include <string_view>

namespace brewster {

/// Checks the JSON of a glTF file before a lenient parser sees it: well formed, at most 64 levels deep, and every
/// property that this program reads of the type and length the specification asks for; no index is negative or beyond
/// 31 bits. `where` stands in the Error.
void check_gltf_text(std::string_view json, const std::string& where);

}  // namespace brewster
