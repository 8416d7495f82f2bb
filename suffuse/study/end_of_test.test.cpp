#include "suffuse/study/end_of_test.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::study {
namespace {

/// A dense sample: q rises to a peak and falls to `residual` [Pa], dilating ever less.
std::vector<triaxial::PathRow> sheared_to(double strain, double residual = 2e5) {
    std::vector<triaxial::PathRow> rows;
    const int steps = static_cast<int>(std::lround(strain / 1e-3));
    for (int k = 0; k <= steps; ++k) {
        triaxial::PathRow row;
        row.axial_strain = strain * k / steps;
        row.deviator_stress = residual * (1 - std::exp(-row.axial_strain / 0.005)) +
                              1e5 * (row.axial_strain / 0.03) * std::exp(-row.axial_strain / 0.03);
        row.volumetric_strain = -0.1 * (1 - std::exp(-row.axial_strain / 0.08));
        row.void_ratio = 0.7 - row.volumetric_strain;
        row.mean_stress = 1e5 + row.deviator_stress / 3;
        rows.push_back(row);
    }
    return rows;
}

TEST(EndOfTest, OfALongTestIsItsCriticalState) {
    const std::optional<EndOfTest> end = end_of_test(sheared_to(0.45));
    ASSERT_TRUE(end);
    EXPECT_TRUE(end->is_critical());
    EXPECT_NEAR(end->deviator, 2e5, 20) << "what is left of the peak there is below 1e-4";
    EXPECT_NEAR(end->mean_ratio, 2 / (1 + 2. / 3), 1e-3);
    // The line's slope lies between those at its ends: 1.25 exp(-0.35/0.08) and 1.25 exp(-0.45/0.08).
    EXPECT_GT(end->dilation, 1.25 * std::exp(-0.45 / 0.08));
    EXPECT_LT(end->dilation, 1.25 * std::exp(-0.35 / 0.08));
}

TEST(EndOfTest, OfAShortTestStillDilatesAndOfAVeryShortOneIsUnknown) {
    const std::optional<EndOfTest> end = end_of_test(sheared_to(0.2));
    ASSERT_TRUE(end);
    EXPECT_FALSE(end->is_critical());
    EXPECT_FALSE(end_of_test(sheared_to(0.1)));
    EXPECT_FALSE(end_of_test({}));
}

TEST(EndOfTest, AStressThatGoesOnFallingIsNotCritical) {
    std::vector<triaxial::PathRow> rows = sheared_to(0.45);
    for (triaxial::PathRow& row : rows) {
        row.deviator_stress = 2e5 * (1 - 1.5 * row.axial_strain);
        row.volumetric_strain = 0;
    }
    const std::optional<EndOfTest> end = end_of_test(rows);
    ASSERT_TRUE(end);
    EXPECT_NEAR(end->drift, -0.15 / (1 - 1.5 * 0.4), 1e-9);
    EXPECT_FALSE(end->is_critical());
}

TEST(EndOfTest, IsCriticalUpToADilationOfATenthAndADriftOfAQuarter) {
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_TRUE((EndOfTest{.dilation = sign * 0.099, .drift = sign * 0.249}.is_critical()));
        EXPECT_FALSE((EndOfTest{.dilation = sign * 0.101}.is_critical()));
        EXPECT_FALSE((EndOfTest{.drift = sign * 0.251}.is_critical()));
    }
}

TEST(EndOfTest, TheStressAtAStrainIsReadBetweenRows) {
    std::vector<triaxial::PathRow> rows(2);
    rows[1].axial_strain = 0.1, rows[1].deviator_stress = 100;
    EXPECT_NEAR(deviator_at(rows, 0.025), 25, 1e-12);
    EXPECT_NEAR(deviator_at(rows, 0.1), 100, 1e-12);
    EXPECT_TRUE(std::isnan(deviator_at(rows, 0.11)));
    EXPECT_EQ(deviator_at(rows, 0), 0);
}

} // namespace
} // namespace suffuse::study
