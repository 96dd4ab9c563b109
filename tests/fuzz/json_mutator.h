#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace brewster {

/// The bytes of a .gltf or .glb file with one change inside the JSON: a value replaced, copied to another place, left
/// out, or repeated. So files stay files, where changed bytes would end at the parser. The same text where it is no JSON.
std::string with_changed_json(const std::string& file, std::uint32_t seed);

/// LLVMFuzzerCustomMutator of JSON: such a change, but of bytes once in `bytes_once_in` times and where it grows too long.
inline std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed,
                               unsigned bytes_once_in) {
    if (seed % bytes_once_in == 0) return LLVMFuzzerMutate(data, size, most);
    const std::string changed =
        with_changed_json(std::string(reinterpret_cast<char*>(data), size), seed / bytes_once_in);
    if (changed.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, changed.data(), changed.size());
    return changed.size();
}

}  // namespace brewster
