#include "base/threads.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(Threads, EachIndexOnceOnAThreadThatIsThere) {
    for (const unsigned threads : {1u, 2u, 5u}) {
        std::vector<std::atomic<int>> calls(1000);
        std::atomic<bool> known = true;
        on_threads(1000, threads, [&](int index, unsigned thread) {
            ++calls[static_cast<std::size_t>(index)];
            if (thread >= threads) known = false;
        });
        for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
        EXPECT_TRUE(known);
    }
    on_threads(0, 3, [](int, unsigned) { FAIL() << "there is nothing to do"; });
}

TEST(Threads, RangesCoverAllAndAreTheSameForAnyThreads) {
    for (const std::size_t count : {0u, 1u, 64u, 1000u}) {
        for (const unsigned threads : {1u, 3u}) {
            std::vector<std::atomic<int>> calls(count);
            over_ranges(count, 64, threads, [&](std::size_t begin, std::size_t end) {
                EXPECT_EQ(begin % 64, 0u);
                EXPECT_EQ(end, std::min(begin + 64, count));
                for (std::size_t i = begin; i < end; ++i) ++calls[i];
            });
            for (const std::atomic<int>& calls_of_one : calls) EXPECT_EQ(calls_of_one, 1);
        }
    }
}

TEST(Threads, AsManyAsWanted) {
    EXPECT_EQ(thread_count(7), 7u);
    EXPECT_GE(thread_count(), 1u);
}

}  // namespace
}  // namespace brewster
