#include "transport/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bench.h"
#include "rooms.h"

namespace brewster {
namespace {

TEST(TracePhoton, LedgerBalancesToTheLastQuantum) {
    for (const char* name : {"cornell-box.gltf", "furnace.gltf"}) {
        const auto scene = rooms::read(name);
        Bench bench(*scene);
        bench.trace(0, 20000);
        EXPECT_TRUE(bench.sums.ledger.balances()) << name;
        EXPECT_EQ(bench.sums.counts.photons, 20000u);
        EXPECT_EQ(bench.sums.counts.trouble, 0u);
        for (std::size_t band = 0; band < band_count; ++band) {
            EXPECT_GT(bench.sums.ledger.absorbed[0][band], 0);
            EXPECT_EQ(bench.sums.ledger.cut[0][band], 0);
        }
    }
}

TEST(Ledger, AMissingQuantumIsNoticed) {
    Ledger ledger;
    EXPECT_TRUE(ledger.balances());
    ledger.emitted[0][1] += 5;
    ledger.absorbed[0][1] += 4;
    EXPECT_FALSE(ledger.balances());
    ledger.roulette[0][1] += 1;
    EXPECT_TRUE(ledger.balances());
}

TEST(TracePhoton, AClosedRoomLosesNothing) {
    const auto scene = rooms::read("furnace.gltf");
    Bench bench(*scene);
    bench.trace(0, 100000);
    for (std::size_t band = 0; band < band_count; ++band) EXPECT_EQ(bench.sums.ledger.escaped[0][band], 0);
}

TEST(TracePhoton, APhotonDependsOnItsIndexAlone) {
    const auto scene = rooms::read("cornell-box.gltf");
    Bench forward(*scene), backward(*scene);
    forward.trace(0, 500);
    for (std::uint64_t photon = 500; photon-- > 0;) backward.trace(photon, photon + 1);
    for (std::uint32_t leaf = 0; leaf < forward.sums.entry.leaves(); ++leaf) {
        EXPECT_EQ(0, std::memcmp(forward.sums.entry.estimate(leaf), backward.sums.entry.estimate(leaf),
                                 sizeof(Quanta) * static_cast<std::size_t>(RecordLayout<2>{}.estimate_size())));
    }
    EXPECT_EQ(forward.sums.counts.bounces, backward.sums.counts.bounces);
}

// Furnace of albedo 1/2 and emission 1: every wall of 1 m2 gets pi lumen direct and pi indirect. Photons of n = 2e5:
// the direct flux of a wall is a share 1/6 of all, binomial at most: relative error sqrt(5/n) = 0.5 %; the indirect one
// is a sum of a geometric number of weights, its relative error below sqrt(24/n) = 1.1 %. Bounds are 4 standard errors.
TEST(TracePhoton, FurnaceWallsGetPiTwice) {
    const auto scene = rooms::read("furnace.gltf");
    Bench bench(*scene);
    bench.trace(0, 200000);
    double direct = 0, indirect = 0;
    for (std::uint32_t chart = 0; chart < 6; ++chart) {
        EXPECT_NEAR(bench.flux(chart, true, 0), pi, 0.02 * pi);
        EXPECT_NEAR(bench.flux(chart, false, 1), pi, 0.044 * pi);
        direct += bench.flux(chart, true, 0) / 6;
        indirect += bench.flux(chart, false, 1) / 6;
    }
    EXPECT_NEAR(direct, pi, 1e-5 * pi);  // nothing escapes: the mean of the walls is exact
    // The weights of a photon after its first hit sum to 1 in the mean, with variance below 2 (roulette).
    EXPECT_NEAR(indirect, pi, 4 * std::sqrt(2.0 / 200000) * pi);
    // The roulette account is zero on average; per photon it moves less than one unit of weight.
    EXPECT_LT(std::abs(to_weight(bench.sums.ledger.roulette[0][0])), 4 * std::sqrt(200000.0));
}

// Every kernel keeps its books to the quantum, in both worlds, and gives up no photon.
TEST(TracePhoton, EveryKernelBalances) {
    for (const char* name : {"gloss-lab.gltf", "metal-lab.gltf", "brewster-room.gltf", "spheres.gltf"}) {
        const auto scene = rooms::read(name);
        for (const int stokes : {1, 3, 4})
            for (const int bands : {1, 3})
                for (const bool gloss : {false, true}) {
                    Bench bench(*scene, 1, {stokes, bands, gloss});
                    bench.trace(0, 1000);
                    EXPECT_TRUE(bench.sums.ledger.balances()) << name << stokes << bands << gloss;
                    EXPECT_EQ(bench.sums.counts.trouble, 0u) << name << stokes << bands << gloss;
                    EXPECT_EQ(bench.sums.ledger.emitted[1][0] > 0, stokes > 1);
                }
    }
}

// A path is sampled the same way whatever it carries: the unpolarized world of the paired kernels is, photon by photon,
// the world of the kernel that knows no polarization, but where the roulette looked at both weights. With the bench's
// single cells, the direct light that enters bases is equal to the last bit; the rest within errors of 2000 photons.
TEST(TracePhoton, TheUnpolarizedWorldIsThatOfTheScalarKernel) {
    const auto scene = rooms::read("gloss-lab.gltf");
    Bench alone(*scene, 1, {1, 3, false}), paired(*scene, 1, {3, 3, false}), full(*scene, 1, {4, 3, false});
    for (Bench* bench : {&alone, &paired, &full}) bench->trace(0, 20000);
    EXPECT_EQ(paired.sums.ledger.emitted[1], alone.sums.ledger.emitted[0]);
    for (std::size_t band = 0; band < band_count; ++band) {
        const double absorbed = to_weight(alone.sums.ledger.absorbed[0][band]);
        EXPECT_NEAR(to_weight(paired.sums.ledger.absorbed[1][band]) / absorbed, 1.0, 0.02);
        EXPECT_NEAR(to_weight(full.sums.ledger.absorbed[1][band]) / absorbed, 1.0, 0.02);
    }
    for (std::uint32_t chart = 0; chart < scene->charts.size(); ++chart)
        for (std::size_t band = 0; band < band_count; ++band) {
            EXPECT_EQ(paired.flux(chart, true, band), alone.flux(chart, true, band));
            EXPECT_EQ(full.flux(chart, true, band), alone.flux(chart, true, band));
        }
}

}  // namespace
}  // namespace brewster
