#include "base/digest.h"

#include <array>
#include <cstdio>

namespace brewster {

std::string Digest::hexadecimal() const {
    std::array<char, 33> text{};
    std::snprintf(text.data(), text.size(), "%016llx%016llx", static_cast<unsigned long long>(high_),
                  static_cast<unsigned long long>(low_));
    return text.data();
}

}  // namespace brewster
