#include "suffuse/run/erosion_figures.hpp"

#include <gtest/gtest.h>

namespace suffuse::run {
namespace {

TEST(StabilityOfARun, IsSaidToBeThatOfTheSimulatedGrading) {
    casefile::Variant variant;
    variant.soil.emplace().whole = {{1e-4, 2e-4, 4e-4}, {0, 0.5, 1}, "invented"};
    const FinishedStage eroded{nullptr, &variant, nullptr, {}, {}};
    ErosionStory story;
    story.eroded = &eroded;
    report::ReportData data;
    show_stability({}, story, data);
    ASSERT_EQ(data.tables.size(), 1U);
    EXPECT_EQ(data.tables.front().title, "Internal stability by the simulated grading");
    EXPECT_NE(data.tables.front().note.find("the whole soil may be less stable"), std::string::npos);
    EXPECT_EQ(data.tables.front().rows.front()[3], "≥ 1.3");
    EXPECT_EQ(data.figures.size(), 2U);
}

} // namespace
} // namespace suffuse::run
