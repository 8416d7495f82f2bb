#include "suffuse/base/arctangent.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace suffuse {
namespace {

TEST(Arctangent, IsThatOfTheStandardLibraryAllAround) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> turn(-pi, pi), decade(-12, 12);
    for (int i = 0; i < 1'000'000; ++i) {
        const double size = std::pow(10, decade(random)), angle = turn(random);
        const double x = size * std::cos(angle), y = size * std::sin(angle);
        const double expected = std::atan2(y, x);
        ASSERT_NEAR(arctangent(y, x), expected, 4e-16 * std::abs(expected)) << y << ", " << x;
    }
}

TEST(Arctangent, KeepsItsDigitsNextToTheAxes) {
    for (double small = 1; small > 1e-300; small *= 0.37) {
        EXPECT_NEAR(arctangent(small, 1) / std::atan2(small, 1), 1, 4e-16) << small;
        EXPECT_NEAR(arctangent(1, small), std::atan2(1, small), 4e-16) << small;
        EXPECT_NEAR(arctangent(small, -1), std::atan2(small, -1), 6e-16) << small;
        EXPECT_NEAR(arctangent(-small, 1) / std::atan2(-small, 1), 1, 4e-16) << small;
    }
}

TEST(Arctangent, HasItsValuesWhereAnAxisOrADiagonalIsMet) {
    for (const double size : {std::numeric_limits<double>::denorm_min(), 1e-160, 1.0, 1e300}) {
        EXPECT_EQ(arctangent(0, size), 0);
        EXPECT_EQ(arctangent(size, 0), pi / 2);
        EXPECT_EQ(arctangent(-size, 0), -pi / 2);
        EXPECT_EQ(arctangent(0, -size), pi);
        EXPECT_EQ(arctangent(size, size), pi / 4);
        EXPECT_EQ(arctangent(size, -size), 3 * pi / 4);
    }
    EXPECT_EQ(arctangent(0, 0), 0);
}

} // namespace
} // namespace suffuse
