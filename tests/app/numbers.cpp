#include "app/numbers.h"

#include <gtest/gtest.h>

namespace brewster {
namespace {

TEST(Numbers, WholeNumbersAreExact) {
    EXPECT_EQ(parse_whole_number("0"), 0u);
    EXPECT_EQ(parse_whole_number("2e7"), 20000000u);
    EXPECT_EQ(parse_whole_number("2E+7"), 20000000u);
    EXPECT_EQ(parse_whole_number("1.5e6"), 1500000u);
    EXPECT_EQ(parse_whole_number("1.50"), std::nullopt);
    EXPECT_EQ(parse_whole_number("1.0"), 1u);
    EXPECT_EQ(parse_whole_number("1500e-2"), 15u);
    EXPECT_EQ(parse_whole_number("0e99999"), 0u);
    EXPECT_EQ(parse_whole_number("007"), 7u);
    // A double would round both.
    EXPECT_EQ(parse_whole_number("9007199254740993"), 9007199254740993u);
    EXPECT_EQ(parse_whole_number("1.8446744073709551615e19"), 18446744073709551615u);
}

TEST(Numbers, WhatIsNotAWholeNumberIsRefused) {
    for (const char* text : {"",
                             "1.5",
                             "1e30",
                             "18446744073709551616",
                             "1e-1",
                             "15e-1",
                             "-1",
                             "+1",
                             " 1",
                             "1 ",
                             "1e",
                             "e7",
                             ".",
                             "1..2",
                             "1e7x",
                             "0x10",
                             "inf",
                             "nan",
                             "1e99999999999",
                             "1,5"}) {
        EXPECT_EQ(parse_whole_number(text), std::nullopt) << '\'' << text << '\'';
    }
}

TEST(Numbers, DecimalNumbers) {
    EXPECT_EQ(parse_number("-1.5"), -1.5);
    EXPECT_EQ(parse_number("2e-3"), 2e-3);
    for (const char* text : {"", "1.5s", "nan", "inf", "1e999", " 1", "0x1p3"}) {
        EXPECT_EQ(parse_number(text), std::nullopt) << '\'' << text << '\'';
    }
}

TEST(Numbers, Sizes) {
    const std::optional<PictureSize> size = parse_size("640x480");
    ASSERT_TRUE(size);
    EXPECT_EQ(size->width, 640);
    EXPECT_EQ(size->height, 480);
    for (const char* text : {"", "640", "x480", "640x", "0x480", "640x480x3", "640X480", "16385x1", "-1x1"}) {
        EXPECT_FALSE(parse_size(text)) << '\'' << text << '\'';
    }
}

TEST(Numbers, WordsForPeople) {
    EXPECT_EQ(significant(0.03125), "0.0312");
    EXPECT_EQ(significant(2.0), "2");
    EXPECT_EQ(with_error(0.2684, 0.04), "0.27");
    EXPECT_EQ(with_error(-0.00161, 0.0006), "-0.0016");
    EXPECT_EQ(with_error(438.2, 40), "438");
    EXPECT_EQ(with_error(0.00015432, 0.000001), "0.00015");
    EXPECT_EQ(with_error(12.3456, 0), "12.3");
    EXPECT_EQ(with_magnitude(12345678), "12.35 M");
    EXPECT_EQ(with_magnitude(999), "999");
    EXPECT_EQ(with_magnitude(480000), "480 k");
}

}  // namespace
}  // namespace brewster
