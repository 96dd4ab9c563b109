#include "bins/hidden_structure.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace brewster {
namespace {

/// Leaves of unit noise in charts of `size`, with that much structure each, known to +- 4.5.
std::vector<LeafExcess> leaves_of(std::size_t count, double structure) {
    std::mt19937 random(7);
    std::normal_distribution<double> chance(structure, 4.5);
    std::vector<LeafExcess> leaves(count);
    for (LeafExcess& leaf : leaves) leaf = {chance(random), 1};
    return leaves;
}

std::vector<std::size_t> charts_of(std::size_t count, std::size_t size) {
    std::vector<std::size_t> begin;
    for (std::size_t i = 0; i <= count; i += size) begin.push_back(i);
    return begin;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(HiddenStructure, ChanceAloneIsNotTakenForIt) {
    const std::vector<double> hidden = hidden_structure(leaves_of(200, 0), charts_of(200, 20));
    EXPECT_LT(mean(hidden), 0.2);
    for (const double h : hidden) EXPECT_GE(h, 0);
}

TEST(HiddenStructure, WhatAllLeavesHoldIsFound) {
    const std::vector<LeafExcess> leaves = leaves_of(2000, 8);
    const double found = mean(hidden_structure(leaves, charts_of(2000, 200)));
    // Half of the chart's, and of the leaf's own what stands out by two deviations, about .07 of a deviation of 4.5 more.
    EXPECT_GT(found, 3);
    EXPECT_LT(found, 8);
}

TEST(HiddenStructure, OneLeafThatStandsOutKeepsMostOfItsOwn) {
    std::vector<LeafExcess> leaves = leaves_of(100, 0);
    leaves[50] = {100, 1};
    const std::vector<double> hidden = hidden_structure(leaves, charts_of(100, 25));
    EXPECT_GT(hidden[50], 40);
    EXPECT_LT(hidden[10], 5);  // of another chart
}

TEST(HiddenStructure, LeavesWithoutLightSayNothing) {
    std::vector<LeafExcess> leaves = leaves_of(40, 6);
    const std::vector<double> alone = hidden_structure(leaves, std::vector<std::size_t>{0, 40});
    leaves.resize(60);
    const std::vector<double> together = hidden_structure(leaves, std::vector<std::size_t>{0, 40, 60});
    for (std::size_t i = 0; i < 40; ++i) EXPECT_DOUBLE_EQ(alone[i], together[i]);
    for (std::size_t i = 0; i < 60; ++i) EXPECT_TRUE(together[i] >= 0);
    EXPECT_EQ(hidden_structure(std::vector<LeafExcess>(3), std::vector<std::size_t>{0, 3}),
              std::vector<double>(3, 0.0));
}

}  // namespace
}  // namespace brewster
