// SPDX-License-Identifier: MIT
#include "editor/widgets/arithmetic.h"

#include <gtest/gtest.h>

#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

TEST(ValueOfSum, KnowsTheOrderOfOperations) {
    EXPECT_EQ(value_of_sum("1+2*3"), 7.0);
    EXPECT_EQ(value_of_sum("(1+2)*3"), 9.0);
    EXPECT_EQ(value_of_sum("2048/4 - 12"), 500.0);
    EXPECT_EQ(value_of_sum("-(2-5)"), 3.0);
}

TEST(ValueOfSum, ReadsWhatTheInterfaceWrites) {
    EXPECT_EQ(value_of_sum(number_text(-0.25)), -0.25);
    EXPECT_EQ(value_of_sum(number_text(85.0, {.decimals = 0, .unit = "%"})), 85.0);
    EXPECT_EQ(value_of_sum("15.0\u00b0"), 15.0);
    EXPECT_EQ(value_of_sum("0,5"), 0.5);
}

TEST(ValueOfSum, RefusesWhatIsNoSum) {
    for (const char* text : {"", "  ", "abc", "1+", "2*", "(1", "1)", "1 2", "1/0", "--", "1..2"})
        EXPECT_EQ(value_of_sum(text), std::nullopt) << text;
}

TEST(ValueOfSum, RefusesEndlessNesting) {
    EXPECT_EQ(value_of_sum(std::string(10000, '(') + "1" + std::string(10000, ')')), std::nullopt);
    EXPECT_EQ(value_of_sum(std::string(10000, '-') + "1"), std::nullopt);
}

TEST(NumberText, WritesATrueMinusAndNoNegativeZero) {
    EXPECT_EQ(number_text(-1.5), "\u22121.50");
    EXPECT_EQ(number_text(-0.001), "0.00");
    EXPECT_EQ(number_text(0.3, {.always_signed = true}), "+0.30");
    EXPECT_EQ(number_text(92.0, {.decimals = 0, .unit = "%"}), "92 %");
    EXPECT_EQ(number_text(15.0, {.decimals = 1, .unit = "\u00b0"}), "15.0\u00b0");
}

}  // namespace
}  // namespace patina::editor
