#include "engine/engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "base/error.h"
#include "base/units.h"
#include "bins/lookup.h"
#include "slow.h"
#include "trace.h"
#include "transport/rooms.h"

namespace brewster {
namespace {

EngineSettings with_threads(unsigned threads) {
    EngineSettings settings;
    settings.threads = threads;
    return settings;
}

StopRule photons(std::uint64_t count) {
    StopRule rule;
    rule.photons = count;
    return rule;
}

constexpr std::uint64_t some = slow ? 60000 : 400000;

TEST(Engine, DigestDoesNotDependOnThreads) {
    const auto scene = rooms::read("cornell-box.gltf");
    std::string first;
    for (const unsigned threads : {1u, 2u, 5u}) {
        Engine engine(scene, with_threads(threads));
        trace(engine, some);
        if (threads == 1) first = engine.digest();
        EXPECT_EQ(engine.digest(), first) << threads << " threads";
        EXPECT_TRUE(engine.ledger().balances());
        EXPECT_EQ(engine.progress().photons, some);
        std::uint64_t sum = 0;
        for (const std::uint64_t share : engine.progress().photons_by_thread) sum += share;
        EXPECT_EQ(sum, some);
    }
}

TEST(Engine, DigestDependsOnSeedAndCount) {
    const auto scene = rooms::read("cornell-box.gltf");
    std::vector<std::string> digests;
    for (const std::uint64_t seed : {1ull, 2ull}) {
        for (const std::uint64_t count : {20000ull, 20001ull}) {
            EngineSettings settings = with_threads(2);
            settings.seed = seed;
            Engine engine(scene, settings);
            trace(engine, count);
            digests.push_back(engine.digest());
        }
    }
    std::sort(digests.begin(), digests.end());
    EXPECT_EQ(std::unique(digests.begin(), digests.end()), digests.end());
}

// Two hundredths of the sun's beam come in by the window. After some ten batches most photons do, and carry the light
// they did: emitted light per photon is the same within its spread (weights of up to 10 in a tenth of the photons: 1 %).
TEST(Engine, GuidesTheSunThroughTheWindow) {
    const auto scene = rooms::read("brewster-room.gltf");
    const std::uint64_t count = slow ? 60000 : 200000;
    std::array<double, 2> emitted{}, escaped{}, useful{};
    for (const bool guided : {false, true}) {
        EngineSettings settings = with_threads(guided ? 2 : 1);
        settings.guided_emission = guided;
        Engine engine(scene, settings);
        trace(engine, count);
        const Ledger ledger = engine.ledger();
        EXPECT_TRUE(ledger.balances());
        emitted[guided] = to_weight(ledger.emitted[1][1]) / static_cast<double>(count);
        escaped[guided] = to_weight(ledger.escaped[1][1]) / static_cast<double>(count);
        useful[guided] = static_cast<double>(engine.progress().useful_photons) / static_cast<double>(count);
    }
    EXPECT_LT(useful[0], 0.05);
    EXPECT_GT(useful[1], slow ? 0.3 : 0.6);
    EXPECT_NEAR(emitted[1] / emitted[0], 1, 0.1);
    EXPECT_NEAR(escaped[1] / escaped[0], 1, 0.1);
}

TEST(Engine, GuidedDigestDoesNotDependOnThreads) {
    const auto scene = rooms::read("brewster-room.gltf");
    std::string first;
    for (const unsigned threads : {1u, 3u}) {
        Engine engine(scene, with_threads(threads));
        trace(engine, slow ? 30000 : 100000);
        if (threads == 1) first = engine.digest();
        EXPECT_EQ(engine.digest(), first) << threads << " threads";
    }
}

TEST(Engine, StopAndGoIsTheSameSolution) {
    const auto scene = rooms::read("cornell-box.gltf");
    Engine through(scene, with_threads(2));
    through.start(photons(some));
    through.wait();

    Engine halting(scene, with_threads(2));  // stops inside batches and blocks
    for (const std::uint64_t count : {some / 7 + 13, some / 3 + 1, some}) {
        halting.start(photons(count));
        halting.wait();
        EXPECT_EQ(halting.snapshot()->photons, count);
    }
    EXPECT_EQ(halting.digest(), through.digest());

    EngineSettings watched = with_threads(2);  // pauses at odd moments, publishes all the time
    watched.snapshot_seconds = 0.002;
    Engine pausing(scene, watched);
    pausing.start(photons(some));
    for (int i = 0; i < 6; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(7));
        pausing.pause();
        pausing.resume();
    }
    pausing.wait();
    EXPECT_EQ(pausing.digest(), through.digest());
    // What is published is the same, too, not only the sums.
    ASSERT_EQ(pausing.snapshot()->leaves.size(), through.snapshot()->leaves.size());
    EXPECT_TRUE(pausing.snapshot()->leaves == through.snapshot()->leaves);
}

TEST(Engine, StopsBySecondsAndByError) {
    const auto scene = rooms::read("cornell-box.gltf");
    Engine timed(scene, with_threads(2));
    StopRule rule;
    rule.seconds = 0.2;
    timed.start(rule);
    timed.wait();
    EXPECT_GE(timed.progress().seconds, 0.2);
    EXPECT_GT(timed.progress().photons, 0u);

    Engine precise(scene, with_threads(2));
    StopRule error;
    error.target_error = 0.2;
    precise.start(error);
    precise.wait();
    EXPECT_LE(precise.progress().relative_error, 0.2);
    EXPECT_GT(precise.progress().relative_error, 0);
    // The batch before was not good enough: the sequence of batches ends with the one that is.
    EXPECT_LT(precise.progress().photons, 200000u);
}

TEST(Engine, DestructionWhileRunningIsClean) {
    const auto scene = rooms::read("cornell-box.gltf");
    for (int i = 0; i < 40; ++i) {
        EngineSettings settings = with_threads(3);
        settings.snapshot_seconds = 0.001;
        Engine engine(scene, settings);
        engine.start(StopRule{});
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 8));
        engine.snapshot();
        engine.progress();
    }
}

TEST(Engine, DarknessIsSaidInWords) {
    auto scene = std::make_shared<Scene>(*rooms::read("cornell-box.gltf"));
    scene->lamps.clear();
    try {
        Engine engine(scene, with_threads(1));
        FAIL() << "an engine without light was made";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("no lamp gives light"), std::string::npos);
    }
}

TEST(Engine, MemoryBudgetHolds) {
    const auto scene = rooms::read("cornell-box.gltf");
    EngineSettings settings = with_threads(2);
    settings.bins.memory_bytes = 8u << 20;
    settings.bins.split_z_squared = 1;
    Engine engine(scene, settings);
    trace(engine, 400000);
    EXPECT_LE(engine.progress().bytes, settings.bins.memory_bytes);
    EXPECT_GT(engine.progress().bytes, settings.bins.memory_bytes / 2);
}

/// Largest |z| that n normal numbers reach with probability 1e-4 (Sidak).
double sidak_bound(double n) {
    const double tail = 1 - std::pow(1 - 1e-4, 1 / n);
    double low = 0, high = 20;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > tail ? low : high) = middle;
    }
    return low;
}

// Entered flux is pi E / (1 - albedo) everywhere: 1536 cells of a fixed grid against it, each by its own error bar.
TEST(Engine, FurnaceCellsDeviateAsTheirErrorBarsSay) {
    const auto scene = rooms::read("furnace.gltf");
    EngineSettings settings = with_threads(2);
    settings.bins.fixed_grid_log2 = 4;
    settings.bins.join_corners = false;
    Engine engine(scene, settings);
    trace(engine, slow ? 200000 : 2000000);
    const auto bins = engine.snapshot();
    double squares = 0, largest = 0, mean = 0;
    int count = 0;
    for (std::uint32_t chart = 0; chart < 6; ++chart) {
        for (std::uint32_t i = 0; i < 256; ++i) {
            const std::uint32_t step = BREWSTER_UV_ONE / 16, u = (i % 16) * step + step / 2,
                                v = (i / 16) * step + step / 2;
            const auto direct = lookup::look_up(*bins, bins->charts[chart].direct_root, 0u, u, v);
            const auto indirect = lookup::look_up(*bins, bins->charts[chart].indirect_root, 0u, u, v);
            // The middle of a linear cell is its mean; reported is the point-wise error, sqrt(3) of the mean's.
            const double error = std::hypot(direct.standard_error.x, indirect.standard_error.x) / std::sqrt(3.0);
            const double value = static_cast<double>(direct.value.x + indirect.value.x);
            const double z = (value - 2 * pi) / error;
            squares += z * z;
            largest = std::max(largest, std::abs(z));
            mean += value;
            ++count;
        }
    }
    EXPECT_EQ(count, 1536);
    EXPECT_LT(largest, sidak_bound(count));
    EXPECT_NEAR(squares / count, 1, 0.15);  // 4 standard deviations of a chi-square of 1536: 0.144
    EXPECT_NEAR(mean / count, 2 * pi, 0.002 * 2 * pi);
}

TEST(Engine, FurnaceWallsStayWhole) {
    const auto scene = rooms::read("furnace.gltf");
    Engine engine(scene, with_threads(2));
    trace(engine, some);
    for (const ChartBins& chart : engine.snapshot()->charts) {
        EXPECT_EQ(chart.direct_leaves, 1u);
        EXPECT_EQ(chart.indirect_leaves, 1u);
    }
}

}  // namespace
}  // namespace brewster
