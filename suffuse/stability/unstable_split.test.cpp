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
    EXPECT_EQ(stable_everywhere_text(narrow).find("it has no gap, H/F is at least"), 0U);
}

} // namespace
} // namespace suffuse::stability
