#include "base/paired_ratio.h"

#include <gtest/gtest.h>

#include "base/philox.h"

namespace brewster {
namespace {

TEST(PairedRatio, OfNothingIsNothing) {
    EXPECT_EQ(PairedRatio().value(), 0);
    EXPECT_EQ(PairedRatio().standard_error(), 0);
}

// x = y/2 has no error at all, however y scatters; halves added together are the whole.
TEST(PairedRatio, WhatBothShareCancels) {
    PairedRatio first, second, all;
    for (std::uint64_t i = 0; i < 100; ++i) {
        const auto y = static_cast<double>(1 + philox(1, i, 0, 0)[0] % 7);
        (i < 50 ? first : second).add(0.5 * y, y);
        all.add(0.5 * y, y);
    }
    first.add(second);
    EXPECT_DOUBLE_EQ(all.value(), 0.5);
    EXPECT_EQ(all.standard_error(), 0);
    EXPECT_DOUBLE_EQ(first.value(), all.value());
}

// Over 1000 runs of 400 samples the ratio scatters as its standard error says: the estimated variance of 1000 runs is
// known to 4.5 % (sqrt(2/1000)), so within 15 % it is right by more than 3 standard errors, and half of it is not.
TEST(PairedRatio, StandardErrorIsTheScatter) {
    double squares = 0, predicted = 0;
    for (std::uint32_t run = 0; run < 1000; ++run) {
        PairedRatio ratio;
        for (std::uint64_t i = 0; i < 400; ++i) {
            const auto words = philox(2, i, run, 0);
            ratio.add(static_cast<double>(unit_float(words[0])), static_cast<double>(unit_float(words[1])));
        }
        squares += (ratio.value() - 1) * (ratio.value() - 1);
        predicted += ratio.standard_error() * ratio.standard_error();
    }
    EXPECT_NEAR(squares / predicted, 1, 0.15);
}

}  // namespace
}  // namespace brewster
