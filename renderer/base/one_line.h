#pragma once
#include <string>

namespace brewster {

/// Text from outside (names in files, arguments) as it may stand in a message: control characters, which would break its
/// line, cut it short or talk to the terminal, become spaces. Bytes of UTF-8 stay.
inline std::string one_line(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    return text;
}

}  // namespace brewster
