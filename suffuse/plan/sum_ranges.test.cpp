#include "suffuse/plan/sum_ranges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace suffuse::plan {
namespace {

TEST(SumRanges, OfOnePartIsThatPart) {
    const Range one = sum_ranges({{0, 0}, {0, 8}});
    EXPECT_EQ(one.least, 0);
    EXPECT_EQ(one.most, 8);
    EXPECT_EQ(sum_ranges({}).most, 0);
}

TEST(SumRanges, OfPartsThatAreKnownIsExact) {
    const Range known = sum_ranges({{100, 100}, {50, 50}});
    EXPECT_EQ(known.least, 150);
    EXPECT_EQ(known.most, 150);
}

TEST(SumRanges, OfManyPartsNarrowsToTheErrorThatTheyShare) {
    const Range few = sum_ranges(std::vector<Range>(4, {1, 9})), many = sum_ranges(std::vector<Range>(10'000, {1, 9}));
    EXPECT_NEAR(middle(few), 12, 1e-9);
    const double own = std::log(3) * std::log(3) - std::log(1.3) * std::log(1.3);
    EXPECT_NEAR(few.most / 12, std::exp(std::sqrt(own / 4 + std::log(1.3) * std::log(1.3))), 1e-9);
    EXPECT_NEAR(many.most / middle(many), 1.3, 1e-3); // 10,000 parts leave a hundredth of their own error
}

TEST(SumRanges, APartThatMayCostNothingCountsWithATenthOfItsMost) {
    const auto most = [](double least) { return sum_ranges({{least, 8}, {8, 8}}).most; };
    EXPECT_EQ(most(0), most(0.79));
    EXPECT_NE(most(0.79), most(0.81));
}

TEST(SumRanges, LiesWithinTheSumsOfTheEnds) {
    const Range all = sum_ranges({{0, 5}, {1, 1.2}});
    EXPECT_GE(all.least, 1);
    EXPECT_LE(all.most, 6.2);
}

} // namespace
} // namespace suffuse::plan
