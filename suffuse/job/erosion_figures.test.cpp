#include "suffuse/job/erosion_figures.hpp"

#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace suffuse::job {
namespace {

TEST(GradingOfASample, HasTheCornersOfTheSpecifiedCurveAndTheLimitOfTheFines) {
    grains::Soil soil;
    soil.whole = {{1e-4, 3e-4, 1.2e-3, 4e-3}, {0, 0.5, 0.5, 1}, "gap"};
    soil.finer_than = 5e-4; // in the gap, where the curve is level
    std::vector<double> radius{0.5e-4, 1.4e-4, 0.61e-3, 2e-3};
    const grains::Grading sampled = sampled_grading(radius, soil);
    const double fines = grains::sample_curve(radius, std::vector{5e-4})[0];
    for (const double size : {3e-4, 5e-4, 1.2e-3}) {
        const auto at = std::ranges::find(sampled.diameter, size);
        ASSERT_NE(at, sampled.diameter.end()) << size;
        EXPECT_EQ(sampled.passing[static_cast<std::size_t>(at - sampled.diameter.begin())], fines) << size;
    }
    EXPECT_TRUE(std::ranges::is_sorted(sampled.diameter, std::less_equal()));
    EXPECT_EQ(sampled_grading(radius, std::nullopt).diameter.size(), 61U);
}

TEST(StabilityOfARun, IsLabeledAsThatOfTheSimulatedGrading) {
    grains::Soil soil;
    soil.whole = {{1e-4, 2e-4, 4e-4}, {0, 0.5, 1}, "invented"};
    report::ReportData data;
    show_stability({}, soil, data);
    ASSERT_EQ(data.tables.size(), 1U);
    EXPECT_EQ(data.tables.front().title, "Internal stability by the simulated grading");
    EXPECT_NE(data.tables.front().note.find("the whole soil may be less stable"), std::string::npos);
    EXPECT_EQ(data.tables.front().rows.front()[3], "≥ 1.3");
    EXPECT_EQ(data.figures.size(), 2U);
}

TEST(StabilityOfARun, OfAPartOfACurveIsShownNextToThatOfTheWhole) {
    grains::Soil soil;
    soil.measured = {{1e-5, 1e-4, 2e-4, 4e-4, 4e-3}, {0.05, 0.3, 0.35, 0.6, 1}, "invented"};
    soil.whole = grains::part_between(*soil.measured, 2e-4, 4e-3);
    report::ReportData data;
    show_stability({}, soil, data);
    ASSERT_EQ(data.tables.size(), 2U);
    EXPECT_EQ(data.tables[0].title, "Internal stability by the whole grading, as measured");
    EXPECT_EQ(data.tables[1].title, "Internal stability by the part of the grading that was simulated");
    EXPECT_EQ(data.tables[0].rows.front()[1], "unstable");
    EXPECT_EQ(data.tables[1].rows.front()[1], "stable");
    EXPECT_EQ(data.figures.size(), 2U);
}

} // namespace
} // namespace suffuse::job
