#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "optics/random_light.h"

namespace brewster {

inline constexpr unsigned threads = 2;

/// BREWSTER_REFERENCE_SCALE: so many times the samples, to look closer. Sanitizer builds, slow ones that look for other
/// faults, take a tenth; bounds follow by the standard errors of the samples.
inline std::uint64_t scaled(std::uint64_t samples) {
    const char* scale = std::getenv("BREWSTER_REFERENCE_SCALE");
    const auto more = static_cast<std::uint64_t>(scale ? std::max(std::atoi(scale), 1) : 1);
    return std::max<std::uint64_t>(samples * more / (light_test_scale == 1 ? 1 : 10), 2);
}

}  // namespace brewster
