#include "suffuse/base/factor_of_safety.hpp"

#include <gtest/gtest.h>

namespace suffuse {
namespace {

TEST(FactorOfSafety, IsNeverRoundedAcrossOne) {
    EXPECT_EQ(factor_text(0.98), "0.98");
    EXPECT_EQ(factor_text(0.996), "0.99");
    EXPECT_EQ(factor_text(1), "1.0");
    EXPECT_EQ(factor_text(1.04), "1.0");
    EXPECT_EQ(factor_text(0.03), "0.03");
    EXPECT_EQ(factor_text(12.34), "12.3");
}

TEST(FactorOfSafety, ThatIsALowerBoundIsNotRaisedByRounding) {
    EXPECT_EQ(least_factor_text(1.49), "1.4");
    EXPECT_EQ(least_factor_text(0.816), "0.81");
    EXPECT_EQ(least_factor_text(0.9999), "0.99");
    EXPECT_EQ(least_factor_text(0.3 / 0.1), "3.0") << "2.9999999999999996";
}

} // namespace
} // namespace suffuse
