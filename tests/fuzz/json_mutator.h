#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace brewster {

/// The bytes of a .gltf or .glb file with one change inside the JSON: a value replaced, copied to another place, left
/// out, or repeated. So files stay files, where changed bytes would end at the parser. The same text where it is no JSON.
std::string with_changed_json(const std::string& file, std::uint32_t seed);

}  // namespace brewster
