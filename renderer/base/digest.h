#pragma once
#include <cstdint>
#include <string>

namespace brewster {

/// A 128-bit hash of a sequence of words, order and all: two multiply-xorshift chains with different constants.
class Digest {
  public:
    void add(std::uint64_t word) {
        low_ = mix(low_ ^ word, 0x9e3779b97f4a7c15ull);
        high_ = mix(high_ + word, 0xd6e8feb86659fd93ull);
    }
    std::string hexadecimal() const;

  private:
    static std::uint64_t mix(std::uint64_t x, std::uint64_t factor) {
        x *= factor;
        x ^= x >> 32;
        x *= factor;
        x ^= x >> 29;
        return x;
    }
    std::uint64_t low_ = 0x243f6a8885a308d3ull, high_ = 0x13198a2e03707344ull;
};

}  // namespace brewster
