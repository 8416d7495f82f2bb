#include "suffuse/stability/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::stability {
namespace {

/// `rise` of the mass between 1 mm and `ratio` mm, `finer` of it in the half size below, the rest in twice the size
/// above.
grains::Grading with_step(double ratio, double finer, double rise = 0) {
    return {{0.5e-3, 1e-3, ratio * 1e-3, 2 * ratio * 1e-3}, {0, finer, finer + rise, 1}, ""};
}

TEST(Gap, IsAFlatPartOfHalfASizeMoreAtLeast) {
    EXPECT_FALSE(find_gap(with_step(1.49, 0.3)));
    const std::optional<Gap> found = find_gap(with_step(1.51, 0.3));
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->fine_end, 1e-3);
    EXPECT_DOUBLE_EQ(found->coarse_end, 1.51e-3);
    EXPECT_DOUBLE_EQ(found->finer, 0.3);
}

TEST(Gap, HasATwentiethOfTheMassOnEitherSide) {
    EXPECT_FALSE(find_gap(with_step(3, 0.049)));
    EXPECT_TRUE(find_gap(with_step(3, 0.06)));
    EXPECT_TRUE(find_gap(with_step(3, 0.94)));
    EXPECT_FALSE(find_gap(with_step(3, 0.951)));
}

TEST(Gap, IsFlatterThanATenthOfTheMassPerTenfoldSize) {
    const double tenfolds = std::log10(4.0);
    EXPECT_TRUE(find_gap(with_step(4, 0.3, 0.099 * tenfolds)));
    EXPECT_FALSE(find_gap(with_step(4, 0.3, 0.101 * tenfolds)));
}

TEST(Gap, IsNotTheTailOfACurveThatBeginsAboveZero) {
    const auto begun_at = [](double passing) {
        return grains::Grading{{1e-6, 10e-6, 0.1e-3, 1e-3}, {passing, passing + 0.09, 0.6, 1}, ""};
    };
    EXPECT_FALSE(find_gap(begun_at(0.05))); // what is missing may taper off as flatly
    EXPECT_TRUE(find_gap(begun_at(0.21)));  // over two tenfold sizes it is steeper than 10 %
    EXPECT_TRUE(find_gap({{1e-6, 2e-6, 20e-6, 0.1e-3, 1e-3}, {.05, .10, .19, .6, 1}, ""})); // steeper where measured
}

TEST(Gap, IsTheWidestOfSeveral) {
    const std::optional<Gap> found = find_gap({{1, 2, 4, 8, 24, 48}, {0, 0.3, 0.3, 0.6, 0.6, 1}, ""});
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->fine_end, 8);
    EXPECT_DOUBLE_EQ(found->coarse_end, 24);
}

} // namespace
} // namespace suffuse::stability
