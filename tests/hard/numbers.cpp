// Memory, counts and seeds at their ends.
#include <gtest/gtest.h>

#include <limits>

#include "base/fixed_point.h"
#include "base/units.h"
#include "engine/batch.h"
#include "engine/slow.h"
#include "hard/hard.h"
#include "transport/emission.h"

namespace brewster {
namespace {

SceneFile lit_room() {
    SceneFile file;
    file.box("room", glm::vec3(0), glm::vec3(1), true, file.material(0.5));
    file.bulb(1, {0.3, 0.4, 0.6});
    return file;
}

// The budget holds, and what is found is as right as ever.
TEST(Numbers, SixteenMegabytes) {
    EngineSettings settings;
    settings.bins.memory_bytes = std::size_t{16} << 20;
    const Solved result = solved(lit_room(), slow ? 20000 : 300000, settings, 4);
    EXPECT_LE(result.largest_bytes, settings.bins.memory_bytes);
    expect_value(result.everywhere, 4 * pi / (6 * 0.5), "in 16 MB");
}

TEST(Numbers, SeedsAtBothEnds) {
    for (const std::uint64_t seed : {std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max() - 3}) {
        EngineSettings settings;
        settings.seed = seed;
        expect_value(solved(lit_room(), slow ? 4000 : 20000, settings, 4).everywhere, 4 * pi / (6 * 0.5), "seed");
    }
}

// 1e12 photons: a batch is at most 2^22 of them and its sums have 64 bits, in quanta of 2^-30 of a photon's weight at
// emission: room for each photon to come by 2000 times with its whole weight. The sums of all batches have 128 bits.
static_assert(0x1p22 * 2000 * quanta_per_weight < 0x1p63);
static_assert(1e12 * 65536 * quanta_per_weight < 0x1p127);

TEST(Numbers, ATrillionPhotonsByArithmetic) {
    BatchSequence batches;
    for (int i = 0; i < 1000; ++i) {
        ASSERT_LE(batches.end() - batches.begin(), std::uint64_t{1} << 22);
        batches.next();
    }
    // Its last photons start like the first: all over the lamp, no two alike.
    const Scene scene = lit_room().read();
    const PhotonEmission emission(scene, 1);
    glm::dvec3 sum(0.0);
    constexpr std::uint64_t last = 1'000'000'000'000, count = 1 << 14;
    for (std::uint64_t i = last - count; i < last; ++i)
        sum += glm::dvec3(glm_vector(emission.sample(i).start.direction));
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(sum[axis] / count, 0, 4 / std::sqrt(3.0 * count));
}

}  // namespace
}  // namespace brewster
