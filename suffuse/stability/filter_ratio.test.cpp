#include "suffuse/stability/filter_ratio.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/gradings_for_tests.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace suffuse::stability {
namespace {

using testing::box;
using testing::two_boxes;

constexpr double rounding = 1e-12;

TEST(FilterRatio, AtTheGapOfTwoBoxesItDoesNotDependOnTheFinesContent) {
    for (const double content : {0.20, 0.25, 0.30, 0.35}) {
        const FilterRatio ratio = filter_ratio(two_boxes(content), 0.30e-3);
        EXPECT_NEAR(ratio.value, std::pow(2, 0.15) / (0.15 * std::pow(2, 0.85)), rounding);
        EXPECT_NEAR(ratio.value, 4.104, 5e-4);
    }
}

TEST(FilterRatio, ABoxHasOneForAllSplits) {
    const double ratio = 2.7;
    EXPECT_NEAR(worst_filter_ratio(box(1e-3, ratio * 1e-3)).value, std::pow(ratio, 0.15), rounding);
    EXPECT_NEAR(filter_ratio(box(1e-3, ratio * 1e-3), 1.3e-3).value, std::pow(ratio, 0.15), rounding);
}

TEST(FilterRatio, TheWorstSplitOfTwoBoxesLeavesTheGapInTheCoarsePart) {
    // D15c at the coarse end of the gap, 1 mm; below d85f lies FC - 15 %.
    const double content = 0.25;
    const FilterRatio worst = worst_filter_ratio(two_boxes(content));
    EXPECT_NEAR(worst.fine, 0.15e-3 * std::pow(2, (content - 0.15) / content), rounding);
    EXPECT_EQ(worst.coarse, 1e-3);
}

TEST(Kezdi, TwoBoxesAreUnstableAndSherardDisagreesAtTheGap) {
    const grains::Grading grading = two_boxes(0.25);
    EXPECT_EQ(kezdi(grading).verdict, Verdict::Unstable);
    EXPECT_EQ(sherard(grading, find_fine_fraction(grading, find_gap(grading), std::nullopt)).verdict, Verdict::Stable);
    EXPECT_FALSE(sherard(grading, std::nullopt).verified);
}

/// Any curve with a handful of points.
grains::Grading some_grading() {
    const auto steps = *rc::gen::container<std::vector<int>>(6, rc::gen::inRange(1, 40));
    const auto rises = *rc::gen::container<std::vector<int>>(6, rc::gen::inRange(0, 10));
    grains::Grading grading{{1e-4}, {0}, ""};
    double total = 1;
    for (const int rise : rises) {
        total += rise;
    }
    double passed = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        grading.diameter.push_back(grading.diameter.back() * std::pow(10, steps[k] / 40.0));
        passed += rises[k];
        grading.passing.push_back(passed / total);
    }
    grading.diameter.push_back(grading.diameter.back() * 1.5);
    grading.passing.push_back(1);
    return grading;
}

TEST(FilterRatio, ATraceOfCoarseOrFineGrainsTurnsNoVerdict) {
    const grains::Grading uniform{{1e-4, 2e-4, 3.15e-4}, {0, 0.5, 1}, {}};
    const double plain = kezdi(uniform).value.value();
    EXPECT_NEAR(plain, std::pow(2, 0.3), 1e-12); // 15 of 50 % per factor 2, the flatter half
    const grains::Grading coarse{{1e-4, 2e-4, 3.15e-4, 4e-4, 4e-3}, {0, 0.5, 0.995, 0.999, 1}, {}};
    const grains::Grading fine{{1e-6, 0.9e-4, 1e-4, 2e-4, 3.15e-4}, {0, 0.001, 0.005, 0.5, 1}, {}};
    for (const grains::Grading& trace : {coarse, fine}) {
        EXPECT_EQ(kezdi(trace).verdict, Verdict::Stable);
        EXPECT_NEAR(kezdi(trace).value.value(), plain, 0.02);
        EXPECT_EQ(sherard(trace, std::nullopt).verdict, Verdict::Stable);
    }
}

TEST(FilterRatio, TheWorstSplitLeavesBothPartsAtLeastAShareOfTheMass) {
    // 15 % of the mass between the end and the corner, by a factor 2 of size; everywhere else they lie closer.
    const grains::Grading steep_above{{1e-3, 2e-3, 2.2e-3}, {0, 0.15, 1}, {}};
    EXPECT_NEAR(worst_filter_ratio(steep_above).split, least_part, rounding);
    const grains::Grading steep_below{{1e-3, 1.1e-3, 2.2e-3}, {0, 0.85, 1}, {}};
    EXPECT_NEAR(worst_filter_ratio(steep_below).split, 1 - least_part, rounding);
    EXPECT_NE(kezdi(steep_below).remark.find("split at F = 95 %"), std::string::npos) << kezdi(steep_below).remark;
}

RC_GTEST_PROP(FilterRatio, TheWorstIsNoLessThanAnyOther, ()) {
    const grains::Grading grading = some_grading();
    const double worst = worst_filter_ratio(grading).value;
    for (int k = 1; k < 100; ++k) {
        const double split = grains::size_at(grading, k / 100.0);
        const double content = grains::passing(grading, split);
        if (content >= least_part && content <= 1 - least_part) {
            RC_ASSERT(filter_ratio(grading, split).value <= worst * (1 + 1e-9));
        }
    }
}

RC_GTEST_PROP(FilterRatio, ExceedsFourExactlyWhereSomeFactorFourHoldsLessThan15Percent, ()) {
    const grains::Grading grading = some_grading();
    const double worst = worst_filter_ratio(grading).value;
    RC_PRE(std::abs(worst - 4) > 1e-6);
    double least = 1;
    for (const ShapePoint& point : shape_curve(grading, 0.85 * least_part, 0.85 * (1 - least_part))) {
        least = std::min(least, point.increment);
    }
    RC_PRE(std::abs(least - 0.15) > 1e-9);
    RC_ASSERT((worst > 4) == (least < 0.15));
}

} // namespace
} // namespace suffuse::stability
