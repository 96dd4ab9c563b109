#include "app/report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace brewster {
namespace {

TEST(Report, DecimalHoldsAllOf128Bits) {
    EXPECT_EQ(decimal(0), "0");
    EXPECT_EQ(decimal(-7), "-7");
    EXPECT_EQ(decimal(Wide{1} << 100), "1267650600228229401496703205376");
    EXPECT_EQ(decimal(std::numeric_limits<Wide>::min()), "-170141183460469231731687303715884105728");
    EXPECT_EQ(decimal(std::numeric_limits<Wide>::max()), "170141183460469231731687303715884105727");
}

SolveResult made_up_result() {
    SolveResult result;
    result.scene = "box";
    result.settings.seed = 9;
    result.progress.photons = 1000;
    result.progress.seconds = 0.5;
    result.progress.photons_by_thread = {600, 400};
    result.progress.useful_photons = 900;
    result.digest = "ab12";
    result.ledger.emitted[0] = {10, 20, 30};
    result.ledger.absorbed[0] = {9, 20, 30};
    result.ledger.roulette[0] = {1, 0, 0};
    return result;
}

TEST(Report, SolveHoldsEveryPromisedField) {
    const auto report = nlohmann::json::parse(solve_report(made_up_result()));
    for (const char* field :
         {"photons", "seconds", "photons_per_second", "photons_by_thread", "bounces", "rays", "bins2", "bytes",
          "digest", "ledger", "relative_error", "first_snapshot_ms", "emission", "trouble", "published_leaves"}) {
        EXPECT_TRUE(report.contains(field)) << field;
    }
    EXPECT_EQ(report["photons"], 1000);
    EXPECT_EQ(report["photons_per_second"], 2000);
    EXPECT_EQ(report["photons_by_thread"], (std::vector<int>{600, 400}));
    EXPECT_EQ(report["emission"]["useful"], 900);
    EXPECT_EQ(report["ledger"]["emitted"], (std::vector<std::string>{"10", "20", "30"}));
    EXPECT_EQ(report["ledger"]["balances"], true);
}

TEST(Report, LedgerThatLeaksSaysSo) {
    SolveResult result = made_up_result();
    result.ledger.emitted[0][2] += 1;
    EXPECT_EQ(nlohmann::json::parse(solve_report(result))["ledger"]["balances"], false);
}

TEST(Report, NamesThatAreNoUtf8StayJson) {
    SolveResult result = made_up_result();
    result.scene = "caf\xe9";
    EXPECT_TRUE(nlohmann::json::accept(solve_report(result)));
}

TEST(Report, CompareLeavesOutWhatIsNotThere) {
    PictureDifference difference;
    difference.pixels = 4;
    std::array<BandDifference, 3> bands;
    bands[0].bias = 0.5;
    bands[1].bias_standard_error = 0.25;
    difference.components[0] = bands;
    const auto report = nlohmann::json::parse(compare_report(difference));
    EXPECT_EQ(report["components"]["S0"]["R"]["bias"], 0.5);
    EXPECT_TRUE(report["components"]["S0"]["R"]["bias_standard_error"].is_null());
    EXPECT_EQ(report["components"]["S0"]["G"]["bias_standard_error"], 0.25);
    EXPECT_FALSE(report["components"].contains("S1"));
}

}  // namespace
}  // namespace brewster
