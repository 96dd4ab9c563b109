#include "transport/guided_emission.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/philox.h"

namespace brewster {
namespace {

// Photons of lamp 1 are useful on a disc that fills 2 % of the square, those of lamp 0 everywhere.
bool is_useful(std::uint32_t lamp, double x, double y) {
    return lamp == 0 || std::hypot(x - 0.3, y - 0.7) < std::sqrt(0.02 / 3.14159265358979);
}

struct Batch {
    double useful_share = 0, flux = 0, flux_squared = 0;  ///< of lamp 1; flux: mean of the weights of useful photons
};

Batch run_batch(EmissionGuide& guide, std::uint64_t first, std::uint64_t photons, bool learn = true) {
    GuideTally tally;
    tally.resize(guide.cell_count());
    Batch batch;
    for (std::uint64_t photon = first; photon < first + photons; ++photon)
        for (const std::uint32_t lamp : {0u, 1u}) {
            const auto words = philox(3, photon, lamp, 0);
            double x = 0x1p-32 * words[0], y = 0x1p-32 * words[1];
            const EmissionGuide::Start start = guide.warp(lamp, x, y);
            ++tally.traced[start.cell];
            if (!is_useful(lamp, x, y)) continue;
            ++tally.useful[start.cell];
            if (lamp == 0) continue;
            const auto weight = static_cast<double>(start.weight), n = static_cast<double>(photons);
            batch.useful_share += 1 / n;
            batch.flux += weight / n;
            batch.flux_squared += weight * weight / n;
        }
    if (learn) guide.learn(tally);
    return batch;
}

EmissionGuide learned() {
    EmissionGuide guide({true, true});
    for (std::uint64_t batch = 0; batch < 12; ++batch) run_batch(guide, batch << 16, 1 << 14);
    return guide;
}

// The flux through the disc stays what it is, within 4 standard errors from the weights' own squares, while nearly all
// of the nine tenths that are guided get through, and the variance falls.
TEST(EmissionGuide, FindsAWindowAndKeepsItsLight) {
    EmissionGuide guide = learned();
    const std::uint64_t photons = 1 << 17;
    const Batch batch = run_batch(guide, 1ull << 32, photons, false);
    EXPECT_GT(batch.useful_share, 0.8);
    const double variance = batch.flux_squared - batch.flux * batch.flux;
    EXPECT_NEAR(batch.flux, 0.02, 4 * std::sqrt(variance / photons));
    EXPECT_LT(variance, 0.02 * 0.98 / 20);  // of plain emission over 20
    EmissionGuide plain({true, true});
    EXPECT_NEAR(run_batch(plain, 1ull << 32, photons, false).useful_share, 0.02, 4 * std::sqrt(0.02 / photons));
}

TEST(EmissionGuide, LampsThatCannotBeGuidedAreNot) {
    EmissionGuide guide({true, false});
    for (std::uint64_t batch = 0; batch < 4; ++batch) run_batch(guide, batch << 16, 1 << 14);
    double x = 0.1, y = 0.1;
    const EmissionGuide::Start start = guide.warp(1, x, y);
    EXPECT_EQ(start.cell, 1u);
    EXPECT_EQ(start.weight, 1.0f);
    EXPECT_EQ(x, 0.1);
}

TEST(EmissionGuide, WhatWastesNothingStaysToTheBit) {
    const EmissionGuide guide = learned();
    for (const double number : {0.0, 0.3, 1 - 0x1p-32}) {
        const double y_before = 1 - 0x1p-32 - number;
        double x = number, y = y_before;
        const EmissionGuide::Start start = guide.warp(0, x, y);
        EXPECT_EQ(start.weight, 1.0f);
        EXPECT_EQ(x, number);
        EXPECT_EQ(y, y_before);
    }
}

// Probabilities are a partition: the mean of the weights over plain numbers is the area, 1; none is above 10.
TEST(EmissionGuide, WeightsAreBoundedAndMeanOne) {
    const EmissionGuide guide = learned();
    double sum = 0, squares = 0;
    const int n = 1 << 16;
    for (int i = 0; i < n; ++i) {
        double x = (i % 256 + 0.5) / 256, y = (i / 256 + 0.5) / 256;
        const auto weight = static_cast<double>(guide.warp(1, x, y).weight);
        EXPECT_GT(weight, 0);
        EXPECT_LE(weight, 10.0001);
        EXPECT_TRUE(x >= 0 && x < 1 && y >= 0 && y < 1);
        sum += weight / n;
        squares += weight * weight / n;
    }
    EXPECT_NEAR(sum, 1, 4 * std::sqrt(squares / n));
}

TEST(EmissionGuide, NodesThatWereWrittenDownComeBack) {
    const EmissionGuide guide = learned();
    EmissionGuide copy({true, true});
    ASSERT_TRUE(copy.restore(guide.nodes()));
    ASSERT_EQ(copy.cell_count(), guide.cell_count());
    for (std::size_t i = 0; i < guide.cell_count(); ++i) {
        if (guide.nodes()[i].low_child == 0) {
            EXPECT_EQ(copy.nodes()[i].weight, guide.nodes()[i].weight);
        }
        EXPECT_EQ(copy.nodes()[i].low_share, guide.nodes()[i].low_share);
    }
    std::vector<EmissionGuide::Node> broken = guide.nodes();
    broken[1].low_child = 1;
    EXPECT_FALSE(copy.restore(broken));
    broken = guide.nodes();
    broken.pop_back();
    EXPECT_FALSE(copy.restore(broken));
    EXPECT_FALSE(copy.restore({}));
    EXPECT_EQ(copy.cell_count(), guide.cell_count());
}

}  // namespace
}  // namespace brewster
