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
            const EmissionGuide::Start<float> start = guide.warp<float>(lamp, words[0], words[1]);
            ++tally.traced[start.cell];
            if (!is_useful(lamp, start.x, start.y)) continue;
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
    const EmissionGuide::Start<float> start = guide.warp<float>(1, 1u << 29, 5u << 29);
    EXPECT_EQ(start.cell, 1u);
    EXPECT_EQ(start.weight, 1.0f);
    EXPECT_EQ(start.x, 0.125f);
    EXPECT_EQ(start.y, 0.625f);
}

TEST(EmissionGuide, WhatWastesNothingStaysToTheBit) {
    const EmissionGuide guide = learned();
    for (const std::uint32_t word : {0u, 0x4ccccccdu, 0x00000123u, 0xffffffffu}) {
        const EmissionGuide::Start<float> start = guide.warp<float>(0, word, ~word);
        const auto number = [](std::uint32_t w) {
            return std::min(0x1p-31f * static_cast<float>(w >> 1), 1 - 0x1p-24f);
        };
        EXPECT_EQ(start.weight, 1.0f);
        EXPECT_EQ(start.x, number(word));
        EXPECT_EQ(start.y, number(~word));
    }
}

// Probabilities are a partition: the mean of the weights over plain numbers is the area, 1; none is above 10.
TEST(EmissionGuide, WeightsAreBoundedAndMeanOne) {
    const EmissionGuide guide = learned();
    double sum = 0, squares = 0;
    const int n = 1 << 16;
    for (int i = 0; i < n; ++i) {
        const auto x = static_cast<std::uint32_t>(i % 256) << 24 | 1u << 23;
        const auto y = static_cast<std::uint32_t>(i / 256) << 24 | 1u << 23;
        const EmissionGuide::Start<float> start = guide.warp<float>(1, x, y);
        const auto weight = static_cast<double>(start.weight);
        EXPECT_GT(weight, 0);
        EXPECT_LE(weight, 10.01);
        EXPECT_TRUE(start.x >= 0 && start.x < 1 && start.y >= 0 && start.y < 1);
        sum += weight / n;
        squares += weight * weight / n;
    }
    EXPECT_NEAR(sum, 1, 4 * std::sqrt(squares / n));
}

// Eight photons at a time are each warped as alone.
TEST(EmissionGuide, LanesGetTheBitsOfOne) {
    const EmissionGuide guide = learned();
    for (std::uint64_t i = 0; i < 2000; ++i) {
        std::array<std::uint32_t, lane_count> lamp, x, y, cell;
        std::array<float, lane_count> moved_x, moved_y, weight;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const auto words = philox(5, i, static_cast<std::uint32_t>(lane), 0);
            lamp[lane] = words[2] & 1u;
            x[lane] = words[0];
            y[lane] = words[1];
        }
        const auto lanes = guide.warp<FloatLanes>(load_words(lamp.data()), load_words(x.data()), load_words(y.data()));
        store(lanes.cell, cell.data());
        store(lanes.x, moved_x.data());
        store(lanes.y, moved_y.data());
        store(lanes.weight, weight.data());
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const EmissionGuide::Start<float> one = guide.warp<float>(lamp[lane], x[lane], y[lane]);
            ASSERT_EQ(cell[lane], one.cell);
            ASSERT_EQ(moved_x[lane], one.x);
            ASSERT_EQ(moved_y[lane], one.y);
            ASSERT_EQ(weight[lane], one.weight);
        }
    }
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
