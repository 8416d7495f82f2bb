#include "suffuse/answer/plain_numbers.hpp"

#include <gtest/gtest.h>

namespace suffuse::answer {
namespace {

TEST(PlainNumbers, AreNeverMinusNothingNorPowersOfTen) {
    EXPECT_EQ(fixed(-1e-14, 2), "0.00");
    EXPECT_EQ(fixed(-0.304, 2), "−0.30");
    EXPECT_EQ(percent_text(0), "none");
    EXPECT_EQ(percent_text(1.11022e-14), "< 0.1 %");
    EXPECT_EQ(percent_text(0.002), "0.2 %");
    EXPECT_EQ(percent_text(0.1349), "13 %");
    EXPECT_EQ(percent_text(1), "100 %");
    EXPECT_EQ(change_text(-1.11022e-14), "none");
    EXPECT_EQ(change_text(0.00049), "none");
    EXPECT_EQ(change_text(0.00051), "+0.1 %");
    EXPECT_EQ(change_text(-0.187), "−19 %");
    EXPECT_EQ(change_text(0.0093), "+0.9 %");
}

TEST(PlainNumbers, ADeviationHasTheDigitsOfItsMean) {
    EXPECT_EQ(spread_text(study::scatter_of({0.28, 0.32}), 1, 2), "± 0.03");
    EXPECT_EQ(spread_text(study::scatter_of({0.3}), 1, 2), "");
    EXPECT_EQ(spread_text(study::scatter_of({0.3, 0.3001}), 1, 2), "") << "they agree to the last digit shown";
    EXPECT_EQ(decimals_for(0.0123, 2), 3);
    EXPECT_EQ(decimals_for(123, 2), 0);
    EXPECT_EQ(decimals_for(0, 2), 0);
}

TEST(PlainNumbers, PermeabilityIsASpeedOfTheWaterFirst) {
    const flow::Fluid water; // K = k ρ g/μ, 9.80665e6 1/(m s) times k
    EXPECT_EQ(conductivity_text(5.6e-11, water), "0.55 mm/s");
    EXPECT_EQ(conductivity_text(1e-13, water), "0.98 µm/s");
    EXPECT_EQ(conductivity_text(1e-6, water), "9.8 m/s");
    EXPECT_EQ(permeability_text(5.64e-11), "5.6 × 10⁻¹¹ m²");
}

} // namespace
} // namespace suffuse::answer
