#include "transport/scalar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "rooms.h"

namespace brewster {
namespace {

/// A scene with one tally cell a chart, and photons traced into it.
struct Bench {
    explicit Bench(const Scene& scene_in, std::uint64_t seed = 1)
        : scene(scene_in),
          rays(scene),
          emission(scene, seed),
          tree(outlines(scene), {}, one_cell()),
          transport(scene, rays, emission, tree, seed) {
        sums.bins.resize(tree.leaf_count());
    }
    static BinSettings one_cell() {
        BinSettings settings;
        settings.fixed_grid_log2 = 0;
        return settings;
    }
    static std::vector<Outline> outlines(const Scene& scene) {
        std::vector<Outline> all(scene.charts.size());
        for (Outline& outline : all) {
            outline.triangles = {{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1)},
                                 {glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}};
        }
        return all;
    }
    void trace(std::uint64_t begin, std::uint64_t end) {
        for (std::uint64_t photon = begin; photon < end; ++photon) transport.trace(photon, sums);
    }
    // Flux into a chart's base in lumen, one band.
    double flux(std::uint32_t chart, bool direct, std::size_t band) const {
        const std::size_t channel = (direct ? 0 : band_count) + band;
        const Quanta* row = sums.bins.estimate(tree.node(chart).leaf()) + channel * RecordLayout<2>::estimate_stride;
        return to_weight(*row) * emission.mean_power() / static_cast<double>(sums.counts.photons);
    }
    const Scene& scene;
    Rays rays;
    PhotonEmission emission;
    BinTree<2> tree;
    ScalarTransport transport;
    WorkerSums sums;
};

TEST(ScalarTransport, LedgerBalancesToTheLastQuantum) {
    for (const char* name : {"cornell-box.gltf", "furnace.gltf"}) {
        const auto scene = rooms::read(name);
        Bench bench(*scene);
        bench.trace(0, 20000);
        EXPECT_TRUE(bench.sums.ledger.balances()) << name;
        EXPECT_EQ(bench.sums.counts.photons, 20000u);
        EXPECT_EQ(bench.sums.counts.trouble, 0u);
        for (std::size_t band = 0; band < band_count; ++band) {
            EXPECT_GT(bench.sums.ledger.absorbed[band], 0);
            EXPECT_EQ(bench.sums.ledger.cut[band], 0);
        }
    }
}

TEST(Ledger, AMissingQuantumIsNoticed) {
    Ledger ledger;
    EXPECT_TRUE(ledger.balances());
    ledger.emitted[1] += 5;
    ledger.absorbed[1] += 4;
    EXPECT_FALSE(ledger.balances());
    ledger.roulette[1] += 1;
    EXPECT_TRUE(ledger.balances());
}

TEST(ScalarTransport, AClosedRoomLosesNothing) {
    const auto scene = rooms::read("furnace.gltf");
    Bench bench(*scene);
    bench.trace(0, 100000);
    for (std::size_t band = 0; band < band_count; ++band) EXPECT_EQ(bench.sums.ledger.escaped[band], 0);
}

TEST(ScalarTransport, APhotonDependsOnItsIndexAlone) {
    const auto scene = rooms::read("cornell-box.gltf");
    Bench forward(*scene), backward(*scene);
    forward.trace(0, 500);
    for (std::uint64_t photon = 500; photon-- > 0;) backward.transport.trace(photon, backward.sums);
    for (std::uint32_t leaf = 0; leaf < forward.sums.bins.leaves(); ++leaf) {
        EXPECT_EQ(0, std::memcmp(forward.sums.bins.estimate(leaf), backward.sums.bins.estimate(leaf),
                                 sizeof(Quanta) * static_cast<std::size_t>(RecordLayout<2>{}.estimate_size())));
    }
    EXPECT_EQ(forward.sums.counts.bounces, backward.sums.counts.bounces);
}

// Furnace of albedo 1/2 and emission 1: every wall of 1 m2 gets pi lumen direct and pi indirect. Photons of n = 2e5:
// the direct flux of a wall is a share 1/6 of all, binomial at most: relative error sqrt(5/n) = 0.5 %; the indirect one
// is a sum of a geometric number of weights, its relative error below sqrt(24/n) = 1.1 %. Bounds are 4 standard errors.
TEST(ScalarTransport, FurnaceWallsGetPiTwice) {
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
    EXPECT_LT(std::abs(to_weight(bench.sums.ledger.roulette[0])), 4 * std::sqrt(200000.0));
}

}  // namespace
}  // namespace brewster
