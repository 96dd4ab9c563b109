#include "scene/uri.h"

#include <optional>

namespace brewster {
namespace {

std::optional<int> hexadecimal(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return {};
}

bool climbs(std::string_view path) {
    while (true) {
        const std::size_t end = path.find_first_of("/\\");
        if (path.substr(0, end) == "..") return true;
        if (end == std::string_view::npos) return false;
        path.remove_prefix(end + 1);
    }
}

}  // namespace

std::string decoded_uri(std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const auto high = uri[i] == '%' && i + 2 < uri.size() ? hexadecimal(uri[i + 1]) : std::nullopt;
        const auto low = high ? hexadecimal(uri[i + 2]) : std::nullopt;
        decoded += low ? static_cast<char>(*high * 16 + *low) : uri[i];
        if (low) i += 2;
    }
    return decoded;
}

bool stays_below(std::string_view uri) {
    if (uri.substr(0, 5) == "data:") return true;
    const std::string path = decoded_uri(uri);
    const std::size_t colon = path.find(':'), slash = path.find_first_of("/\\");
    const bool scheme = colon != std::string::npos && colon < slash;  // of the net, of a drive
    return !path.empty() && !scheme && slash != 0 && !climbs(path) && path.find('\0') == std::string::npos;
}

}  // namespace brewster
