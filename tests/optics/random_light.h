#pragma once
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/philox.h"
#include "base/units.h"
#include "optics/vector.h"

namespace brewster {

/// Sanitizer builds are ten times slower and look for other faults: they run a fifth of the cases.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int light_test_scale = 5;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr int light_test_scale = 5;
#else
inline constexpr int light_test_scale = 1;
#endif
#else
inline constexpr int light_test_scale = 1;
#endif

/// Fixed-seed numbers, directions and states for tests.
class RandomLight {
  public:
    explicit RandomLight(std::uint64_t seed) : seed_(seed) {}

    /// Uniform in [0, 1), 24 bits: exact in float.
    float unit_float() { return brewster::unit_float(word()); }
    /// Uniform in [0, 1), 53 bits.
    double unit() {
        const std::uint64_t high = word(), low = word();
        return static_cast<double>((high << 21) | (low >> 11)) * 0x1p-53;
    }
    double between(double low, double high) { return low + (high - low) * unit(); }

    Vector<double> direction() {
        const double z = between(-1, 1), phi = between(0, 2 * pi), r = std::sqrt((1 - z) * (1 + z));
        return normalized(Vector<double>{r * std::cos(phi), r * std::sin(phi), z});
    }
    /// A direction and a unit axis orthogonal to it.
    std::pair<Vector<double>, Vector<double>> direction_and_axis() {
        const Vector<double> k = direction();
        Vector<double> s = direction();
        s = add_scaled(-dot(s, k), k, s);
        s = add_scaled(-dot(s, k), k, s);
        return {k, normalized(s)};
    }
    std::uint32_t word() {
        if (used_ == 4) {
            words_ = philox(seed_, counter_++, 0, 0);
            used_ = 0;
        }
        return words_[used_++];
    }

  private:
    std::uint64_t seed_, counter_ = 0;
    std::array<std::uint32_t, 4> words_{};
    unsigned used_ = 4;
};

}  // namespace brewster
