#pragma once
#include "base/philox.h"
#include "scene/bsdf.h"

namespace brewster {

/// The random numbers of one path, each a function of (seed, path, bounce, draw) alone: what a path finds does not
/// depend on who follows it.
class PathRandom {
  public:
    /// Eye and light paths of one seed have numbers of their own.
    enum class Kind : std::uint32_t { eye = 0, light = 8 };

    PathRandom(std::uint64_t seed, std::uint64_t path, Kind kind)
        : seed_(seed), path_(path), first_draw_(static_cast<std::uint32_t>(kind)) {}

    /// Four numbers in (0, 1), 32 bits each.
    std::array<double, 4> draw(std::uint32_t bounce, std::uint32_t number) const {
        const auto words = philox(seed_, path_, bounce, first_draw_ + number);
        std::array<double, 4> x;
        for (std::size_t j = 0; j < 4; ++j) x[j] = (static_cast<double>(words[j]) + 0.5) * 0x1p-32;
        return x;
    }

  private:
    std::uint64_t seed_, path_;
    std::uint32_t first_draw_;
};

/// All that one surface asks for; bounce 0 is left to the start of the path.
struct BounceNumbers {
    ScatterNumbers<double> scatter;
    std::array<double, 3> lamp;
    double roulette;

    BounceNumbers(const PathRandom& random, std::uint32_t bounce, bool rough) {
        const auto a = random.draw(bounce, 0), b = random.draw(bounce, 1);
        scatter.choice = a[0];
        scatter.exit_u = a[1];
        scatter.exit_v = a[2];
        roulette = a[3];
        lamp = {b[0], b[1], b[2]};
        scatter.slope = b[3];
        if (!rough) return;
        const auto c = random.draw(bounce, 2);
        scatter.facet_u = c[0];
        scatter.facet_v = c[1];
        scatter.facet_w = c[2];
    }
};

}  // namespace brewster
