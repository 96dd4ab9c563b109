#include "app/progress_line.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(ProgressLine, NearestStopDecides) {
    Progress progress;
    progress.photons = 250;
    progress.seconds = 6;
    progress.relative_error = 0.1;
    EXPECT_DOUBLE_EQ(finished_share(progress, {.photons = 1000, .seconds = {}, .target_error = {}}), 0.25);
    EXPECT_DOUBLE_EQ(finished_share(progress, {.photons = 1000, .seconds = 10, .target_error = {}}), 0.6);
    EXPECT_DOUBLE_EQ(finished_share(progress, {.photons = {}, .seconds = {}, .target_error = 0.05}), 0.25);
    EXPECT_DOUBLE_EQ(finished_share(progress, {.photons = 10, .seconds = {}, .target_error = {}}), 1);
    EXPECT_DOUBLE_EQ(finished_share(progress, {}), 0);
}

TEST(ProgressLine, ShowsTheShare) {
    Progress progress;
    progress.photons = 500;
    const std::string line = progress_line(progress, {.photons = 1000, .seconds = {}, .target_error = {}});
    EXPECT_NE(line.find("[###############...............] 50 %"), std::string::npos) << line;
}

TEST(ProgressLine, TellsTheErrorOnlyWhereItStopsTheRun) {
    Progress progress;
    progress.relative_error = 0.05;
    EXPECT_EQ(progress_line(progress, {.photons = 1000, .seconds = {}, .target_error = {}}).find("error"),
              std::string::npos);
    EXPECT_NE(progress_line(progress, {.photons = {}, .seconds = {}, .target_error = 0.01}).find("error 5 %"),
              std::string::npos);
}

}  // namespace
}  // namespace brewster
