#include "suffuse/stability/kenney_lau.hpp"

#include "suffuse/stability/gradings_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::stability {
namespace {

using testing::power_law;
using testing::two_boxes;

constexpr double rounding_of_shares = 1e-12;

TEST(KenneyLau, APowerLawHasTheSameRatioEverywhere) {
    // H/F = 4^m - 1 for each d up to dmax/4.
    for (const double m : {0.3, 0.4, 0.5, 0.6, 0.7}) {
        for (const double limit : {0.20, 0.30}) {
            EXPECT_NEAR(least_shape_ratio(power_law(m), limit).value, std::pow(4, m) - 1, 1e-9) << m;
        }
    }
}

TEST(KenneyLau, FullersCurveStandsExactlyOnTheLimitOf1986) {
    EXPECT_EQ(kenney_lau_1986(power_law(0.5), 0.2).verdict, Verdict::Stable);
    EXPECT_EQ(kenney_lau_1985(power_law(0.5), 0.2).verdict, Verdict::Unstable);
    EXPECT_EQ(kenney_lau_1986(power_law(0.49), 0.2).verdict, Verdict::Unstable);
    EXPECT_EQ(kenney_lau_1985(power_law(0.61), 0.2).verdict, Verdict::Stable);
}

TEST(KenneyLau, ATruncatedPowerLawGainsAtItsFineEnd) {
    // F = (sqrt(d/10) - 0.1)/0.9 from 0.1 to 10 mm: H/F = 1/(1 - 0.1/sqrt(d/10)), least where F reaches the limit.
    grains::Grading grading;
    constexpr int steps = 400;
    for (int k = 0; k <= steps; ++k) {
        const double d = 0.1 * std::pow(100.0, static_cast<double>(k) / steps);
        grading.diameter.push_back(d * 1e-3);
        grading.passing.push_back((std::sqrt(d / 10) - 0.1) / 0.9);
    }
    grading.passing.front() = 0;
    grading.passing.back() = 1;
    // At F = 0.2, sqrt(d/10) = 0.28. Between points the curve is a chord: 1e-4.
    EXPECT_NEAR(least_shape_ratio(grading, 0.2).value, 1 / (1 - 0.1 / 0.28), 1e-4);
}

TEST(KenneyLau, TwoBoxesMeetTheirMinimumWhereFourTimesTheSizeReachesTheCoarseBox) {
    const double in_fines = std::log2(5.0 / 3.0); // F/FC at 0.25 mm
    for (const double content : {0.20, 0.25}) {
        const LeastRatio least = least_shape_ratio(two_boxes(content), 0.2);
        EXPECT_NEAR(least.value, (1 - in_fines) / in_fines, rounding_of_shares);
        EXPECT_NEAR(least.value, 0.3569, 5e-5);
        EXPECT_NEAR(least.at.diameter, 0.25e-3, rounding_of_shares);
    }
    // With 30 % of fines F = 0.20 comes first, at 0.238 mm.
    const LeastRatio least = least_shape_ratio(two_boxes(0.30), 0.2);
    EXPECT_NEAR(least.at.diameter, 0.15e-3 * std::pow(2, 2.0 / 3), rounding_of_shares);
    EXPECT_NEAR(least.value, 0.5, rounding_of_shares);
    // Narrow primary fabric: up to F = 0.30 the minimum itself counts.
    EXPECT_NEAR(least_shape_ratio(two_boxes(0.30), 0.3).value, (1 - in_fines) / in_fines, rounding_of_shares);
}

TEST(KenneyLau, AtTheCoarseEndOfTheFinesTheRatioFollowsTheFinesContent) {
    for (const auto& [content, ratio] :
         {std::pair(0.20, 1.052), std::pair(0.25, 0.789), std::pair(0.30, 0.614), std::pair(0.35, 0.488)}) {
        for (const ShapePoint& point : shape_curve(two_boxes(content))) {
            if (point.diameter == 0.30e-3) {
                EXPECT_NEAR(point.increment / point.finer, ratio, 5e-4); // the table has three digits
            }
        }
    }
}

TEST(KenneyLau, TheLimitOfFDependsOnTheUniformityOfTheFabric) {
    EXPECT_EQ(finer_limit(3.0), 0.30);
    EXPECT_EQ(finer_limit(3.01), 0.20);
}

TEST(LiFannin, TakesTheMilderOfKenneyLauAndKezdi) {
    // m = 0.3 at the limit: H = 0.516 F, above F = 15 % it must only reach 15 %: least at F = 15 %.
    const Criterion flat = li_fannin(power_law(0.3), 0.2);
    EXPECT_NEAR(*flat.value, std::pow(4, 0.3) - 1, 1e-6);
    EXPECT_EQ(flat.verdict, Verdict::Unstable);
    // H = 16 % at F = 20 % is less than F, but more than Kezdi's 15 %.
    const grains::Grading grading{{0.1e-3, 0.2e-3, 0.8e-3, 1e-3}, {0, 0.2, 0.36, 1}, ""};
    EXPECT_NEAR(least_shape_ratio(grading, 0.2).value, 0.8, rounding_of_shares);
    EXPECT_EQ(kenney_lau_1986(grading, 0.2).verdict, Verdict::Unstable);
    EXPECT_NEAR(*li_fannin(grading, 0.2).value, 0.16 / 0.15, rounding_of_shares);
    EXPECT_EQ(li_fannin(grading, 0.2).verdict, Verdict::Stable);
}

TEST(KenneyLau, OfATraceOfFinesTheRemarkSaysHowLittleCouldLeave) {
    // A uniform sand with 1.3 % of silt far below it.
    const grains::Grading grading{{0.005e-3, 0.03e-3, 0.15e-3, 0.5e-3}, {0, 0.013, 0.013, 1}, "sand"};
    const Criterion criterion = kenney_lau_1986(grading, 0.3);
    EXPECT_EQ(criterion.verdict, Verdict::Unstable) << "by the letter of the rule";
    EXPECT_NE(criterion.remark.find("; a trace: only this 1.3 % of the mass could leave"), std::string::npos)
        << criterion.remark;
    EXPECT_EQ(kenney_lau_1986(two_boxes(0.25), 0.3).remark.find("trace"), std::string::npos);
}

} // namespace
} // namespace suffuse::stability
