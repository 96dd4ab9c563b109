#include "engine/batch.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(BatchSequence, WholeBlocksThatJoinAndGrowToALimit) {
    BatchSequence batch;
    EXPECT_EQ(batch.begin(), 0u);
    std::uint64_t end = 0, length = 0;
    for (int i = 0; i < 100; ++i, batch.next()) {
        EXPECT_EQ(batch.begin(), end);
        EXPECT_EQ(batch.end() % photons_per_block, 0u);
        const std::uint64_t now = batch.end() - batch.begin();
        EXPECT_GE(now, length);
        EXPECT_LE(now, std::uint64_t{1} << 22);
        if (length >= 16 * photons_per_block) {
            EXPECT_LE(now * 10, length * 13);
        }
        length = now;
        end = batch.end();
    }
    EXPECT_EQ(length, std::uint64_t{1} << 22);
}

}  // namespace
}  // namespace brewster
