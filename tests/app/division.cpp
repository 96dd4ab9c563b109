#include "app/division.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brewster {
namespace {

TEST(Division, NoOtherDivisionLeavesLess) {
    for (const double bins : {1e-6, 1e-4, 1e-3}) {
        const Effort photons{1, bins}, draws{0.5, 1e-3};
        const Division best = divided(photons, draws, 10);
        EXPECT_NEAR(best.total(), 10, 1e-9);
        const double least = expected_error(photons, draws, best);
        for (const double shift : {-0.2, -0.01, 0.01, 0.2}) {
            const double moved = best.photons * (1 + shift);
            EXPECT_GT(expected_error(photons, draws, {moved, 10 - moved}), least) << bins << " " << shift;
        }
    }
}

/// At the optimum seconds stand like the errors left times their powers, .6 and 1.2.
TEST(Division, TimeFollowsTheErrors) {
    const Effort photons{1, 1e-4}, draws{0.5, 1e-3};
    const Division best = divided(photons, draws, 10);
    const double bins = expected_error(photons, {0.5, 0}, best), drawn = expected_error({1, 0}, draws, best);
    EXPECT_NEAR(best.photons / best.draws, 0.6 * bins / (1.2 * drawn), 1e-6);
    EXPECT_NEAR(bins, 1e-4 * std::pow(best.photons, -0.6), 1e-12);
}

TEST(Division, WhatDoesNotErrGetsNoTime) {
    EXPECT_NEAR(divided({1, 0}, {1, 1e-3}, 10).photons, 0, 1e-9);
    EXPECT_NEAR(divided({1, 1e-3}, {1, 0}, 10).draws, 0, 1e-9);
}

TEST(Division, TargetsAreMetInTheShortestTime) {
    const Effort photons{1, 1e-4}, draws{0.5, 1e-3};
    const Division plan = division_to(photons, draws, 1e-5);
    EXPECT_NEAR(expected_error(photons, draws, plan), 1e-5, 1e-9);
    EXPECT_GT(expected_error(photons, draws, divided(photons, draws, 0.99 * plan.total())), 1e-5);
}

}  // namespace
}  // namespace brewster
