#include "suffuse/base/quantile.hpp"

#include <gtest/gtest.h>

namespace suffuse {
namespace {

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
    EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_DOUBLE_EQ(quantile({4, 1, 2}, 0.75), 3);
}

TEST(Quantile, OfNothingAndOfEverythingIsTheSmallestAndTheLargest) {
    EXPECT_EQ(quantile({4, 1, 3, 2}, 0), 1);
    EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4);
}

TEST(Quantile, TheUpperOneIsAValueOfTheSample) {
    EXPECT_EQ(upper_quantile({4, 1, 3, 2}, 0.5), 3);
    EXPECT_EQ(upper_quantile({4, 1, 2}, 0.5), 2);
    EXPECT_EQ(upper_quantile({4, 1, 3, 2}, 0.999), 4);
    EXPECT_EQ(upper_quantile({4, 1, 3, 2}, 0), 1);
    EXPECT_EQ(upper_quantile({4, 1, 3, 2}, 1), 4);
}

TEST(Quantile, OfAnEmptySampleIsNotANumber) {
    EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
    EXPECT_TRUE(std::isnan(upper_quantile({}, 0.5)));
}

} // namespace
} // namespace suffuse
