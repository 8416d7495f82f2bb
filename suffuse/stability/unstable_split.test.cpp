#include "suffuse/stability/unstable_split.hpp"

#include <gtest/gtest.h>

namespace suffuse::stability {
namespace {

using grains::Grading;

TEST(UnstableSplit, IsAtTheFineEndOfAGap) {
    const auto split = find_unstable_split(Grading{{0.1e-3, 0.2e-3, 1e-3, 2e-3}, {0, 0.2, 0.2, 1}, ""});
    ASSERT_TRUE(split);
    EXPECT_DOUBLE_EQ(split->finer_than, 0.2e-3);
    EXPECT_NE(split->reason.find("gap"), std::string::npos);
}

TEST(UnstableSplit, IsWhereTheShapeCurveIsWorstIfThereIsNoGap) {
    // 15 % over a factor of 100, then 85 % over one of 10: H/F falls to (0.15 / 2) / 0.15 and below
    const auto split = find_unstable_split(Grading{{0.01e-3, 1e-3, 10e-3}, {0, 0.15, 1}, ""});
    ASSERT_TRUE(split);
    EXPECT_NE(split->reason.find("Kenney and Lau 1986"), std::string::npos) << split->reason;
}

TEST(UnstableSplit, IsNoneWhereTheCoarseGrainsHoldTheFines) {
    const Grading narrow{{0.5e-3, 2e-3}, {0, 1}, ""};
    EXPECT_FALSE(find_unstable_split(narrow));
    EXPECT_EQ(no_split_text(narrow).find("no split of this curve is unstable: it has no gap, H/F is at least"), 0U);
}

TEST(UnstableSplit, IsNoneOfWhatWasNotMeasured) {
    const Grading open{{0.075e-3, 0.15e-3, 0.425e-3, 2e-3, 19e-3, 37.5e-3}, {.08, .16, .35, .64, .94, 1}, ""};
    EXPECT_FALSE(find_unstable_split(open));
    const std::string text = no_split_text(open);
    EXPECT_EQ(text.find("no split of what was measured of this curve is unstable"), 0U) << text;
    EXPECT_NE(text.find("; the 8 % below 0.075 mm were not judged"), std::string::npos) << text;
}

TEST(UnstableSplit, LeavesASkeletonOfCoarseGrains) {
    // Kezdi's worst split has 95 % of fines; up to 40 % there is none.
    EXPECT_FALSE(find_unstable_split({{.01e-3, .075e-3, .3e-3, 1e-3, 4e-3, 10e-3}, {0, .35, .60, .80, .95, 1}, ""}));
    const auto below_gap = [](double content) {
        return Grading{{0.1e-3, 0.2e-3, 1e-3, 2e-3}, {0, content, content, 1}, ""};
    };
    EXPECT_TRUE(find_unstable_split(below_gap(0.40)));
    EXPECT_FALSE(find_unstable_split(below_gap(0.60)));
    EXPECT_NE(no_split_text(below_gap(0.60)).find("60 % are below its gap"), std::string::npos);
}

TEST(UnstableSplit, IsNotAtTheTailOfAHydrometer) {
    const Grading tail{{.002e-3, .006e-3, .02e-3, .075e-3, .3e-3, 1e-3, 4e-3}, {.05, .09, .14, .3, .55, .75, 1}, ""};
    const auto split = find_unstable_split(tail);
    EXPECT_TRUE(!split || split->reason.find("gap") == std::string::npos) << split->reason;
}

} // namespace
} // namespace suffuse::stability
