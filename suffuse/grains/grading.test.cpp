#include "suffuse/grains/grading.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::grains {
namespace {

Grading fontainebleau() {
    return {
        {0.10e-3, 0.15e-3, 0.18e-3, 0.21e-3, 0.25e-3, 0.30e-3, 0.40e-3}, {0, 0.08, 0.25, 0.50, 0.75, 0.92, 1}, "test"};
}

/// F = (d/d_max)^m, cut off where almost nothing is finer.
Grading power_law(double m) {
    Grading grading;
    constexpr int points = 4000;
    constexpr double decades = 40;
    for (int k = 0; k <= points; ++k) {
        const double d = std::pow(10.0, decades * (k - points) / points);
        grading.diameter.push_back(d);
        grading.passing.push_back(k == 0 ? 0.0 : std::pow(d, m));
    }
    return grading;
}

/// Two boxes, uniform in log d: 0.15-0.30 mm and 1-2 mm (R3 of the reference sheet).
Grading two_boxes(double fines_content) {
    return {{0.15e-3, 0.30e-3, 1e-3, 2e-3}, {0, fines_content, fines_content, 1}, "two boxes"};
}

TEST(Grading, IsLinearInTheLogarithmOfSizeBetweenItsPoints) {
    const Grading grading = fontainebleau();
    EXPECT_DOUBLE_EQ(passing(grading, 0.21e-3), 0.50);
    EXPECT_NEAR(passing(grading, std::sqrt(0.21e-3 * 0.25e-3)), 0.625, 1e-14); // rounding
    EXPECT_EQ(passing(grading, 0.05e-3), 0.0);
    EXPECT_EQ(passing(grading, 1e-3), 1.0);
}

TEST(Grading, SizeAtIsTheInverseOfPassing) {
    const Grading grading = fontainebleau();
    for (const double f : {0.01, 0.1, 0.35, 0.5, 0.6, 0.92, 0.999}) {
        EXPECT_NEAR(passing(grading, size_at(grading, f)), f, 1e-14); // rounding
    }
    EXPECT_DOUBLE_EQ(size_at(grading, 0.0), 0.10e-3);
    EXPECT_DOUBLE_EQ(size_at(grading, 1.0), 0.40e-3);
    EXPECT_NEAR(uniformity(grading), 1.46, 0.01); // 0.2254/0.1533, from the curve by hand
}

TEST(Grading, SizeInAGapIsTheFineEndOfTheGap) {
    EXPECT_DOUBLE_EQ(size_at(two_boxes(0.25), 0.25), 0.30e-3);
}

TEST(Grading, PowerLawsHaveTheClosedFormOfKenneyAndLau) { // H/F = 4^m - 1 below a quarter of the largest size
    for (const double m : {0.3, 0.4, 0.5, 0.6, 0.7}) {
        const Grading grading = power_law(m);
        for (const double d : {1e-4, 1e-2, 0.2, 0.25}) {
            // The curve is linear between points that are 2.3 % apart: (m ln 1.023)^2/8 < 4e-5.
            EXPECT_NEAR(kenney_lau_increment(grading, d) / passing(grading, d), std::pow(4.0, m) - 1, 2e-4) << m;
        }
    }
}

TEST(Grading, KenneyLauSplitOfAGapGradedSoilLiesWhereTheCurveComesBackToTheLine) {
    // In the gap F = FC and H = (1 - FC) log2(4 d / 1 mm): equal at d = 2^(FC/(1 - FC))/4 mm.
    for (const double fc : {0.30, 0.35}) {
        const auto split = kenney_lau_split(two_boxes(fc));
        ASSERT_TRUE(split.has_value());
        EXPECT_NEAR(*split, std::exp2(fc / (1 - fc)) / 4 * 1e-3, 1e-12); // rounding
    }
    // At FC = 20 % inside the fines: 0.2 + 0.8 log2(4 d) = 0.4 log2(d/0.15).
    const double log2_d = (0.4 * std::log2(1 / 0.15) - 1.8) / 0.4;
    EXPECT_NEAR(kenney_lau_split(two_boxes(0.20)).value(), std::exp2(log2_d) * 1e-3, 1e-12);
}

TEST(Grading, FontainebleauSandHasNoKenneyLauSplit) { // as the paper found: H/F = 1 only at F = 50 %
    EXPECT_FALSE(kenney_lau_split(fontainebleau()).has_value());
}

TEST(Grading, MixtureAddsMassesOfBothCurves) {
    const Grading coarse{{1e-3, 2e-3}, {0, 1}, "c"}, fines{{0.1e-3, 0.2e-3}, {0, 1}, "f"};
    const Grading mixed = mixture(coarse, fines, 0.2);
    EXPECT_NO_THROW(check(mixed));
    EXPECT_DOUBLE_EQ(passing(mixed, 0.5e-3), 0.2);
    EXPECT_NEAR(passing(mixed, std::sqrt(2.0) * 1e-3), 0.6, 1e-14);
}

std::string complaint(const Grading& grading) {
    try {
        check(grading);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

TEST(Grading, BadCurvesAreRefusedWithThePointNamed) {
    EXPECT_EQ(complaint(fontainebleau()), "");
    EXPECT_NE(
        complaint({{1e-3, 2e-3, 1.5e-3}, {0, 0.5, 1}, "a.csv"}).find("point 3 (1.5 mm: 100 %)"), std::string::npos
    );
    EXPECT_NE(complaint({{1e-3, 2e-3, 3e-3}, {0, 0.5, 0.4}, "a.csv"}).find("must not fall"), std::string::npos);
    EXPECT_NE(complaint({{-1e-3, 2e-3}, {0, 1}, "a.csv"}).find("must be positive"), std::string::npos);
    EXPECT_EQ(complaint({{1.01e-10, 0.99e3}, {0, 1}, "a.csv"}), "");
    EXPECT_NE(complaint({{0.99e-10, 2e-3}, {0, 1}, "a.csv"}).find("check the unit"), std::string::npos);
    EXPECT_NE(complaint({{1e-3, 1.01e3}, {0, 1}, "a.csv"}).find("from 1e-07 to 1e+06 mm"), std::string::npos);
    EXPECT_NE(complaint({{std::nan(""), 2e-3}, {0, 1}, "a.csv"}).find("point 1"), std::string::npos);
    EXPECT_NE(complaint({{1e-3, 2e-3}, {0.1, 1}, "a.csv"}).find("from 10 to 100 %"), std::string::npos);
    EXPECT_NE(complaint({{1e-3, 2e-3}, {0, 55}, "a.csv"}).find("between 0 and 100"), std::string::npos);
    EXPECT_NE(complaint({{1e-3}, {1}, "a.csv"}).find("at least two"), std::string::npos);
}

} // namespace
} // namespace suffuse::grains
