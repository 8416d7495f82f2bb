#include "suffuse/figures/figures_mobility.hpp"

#include "suffuse/figures/figure_guide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace suffuse::figures {
namespace {

/// Small fines move at 0.2, large ones never.
erosion::MobilityResult small_move() {
    erosion::MobilityResult mobility;
    mobility.down = {0, 0, -1}, mobility.direction = {0, 0, 1};
    mobility.heave_gradient = 1;
    mobility.ramp = {{.gradient = 0.2, .mobile_mass_share = 0.25}, {.gradient = 0.4, .mobile_mass_share = 0.25}};
    mobility.id = {1, 2}, mobility.mass = {1, 3}, mobility.diameter = {1e-4, 2e-4};
    mobility.mobile_gradient = {0.2, std::numeric_limits<double>::quiet_NaN()};
    mobility.bears_load = {0, 0};
    mobility.specified_gradient = 0.1;
    return mobility;
}

std::vector<study::MobilityStory> stories_of(const erosion::MobilityResult& mobility) {
    static casefile::Study study;
    static const casefile::Variant variant;
    static const casefile::Stage stage{.name = "mobility", .spec = erosion::DetachStageSpec{}};
    static std::vector<record::FinishedStage> stages;
    stages = {{&study, &variant, &stage, nlohmann::json::object(), {}}};
    stages.back().findings.mobility = mobility;
    return study::gather_mobility(stages);
}

TEST(MobilityFigures, DrawTheCurveWithWhatOtherAnswersSay) {
    const std::optional<Figure> figure = mobility_curves(stories_of(small_move()));
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.numbers("mobile"), (std::vector<double>{25, 25}));
    const std::string chart = figure->chart.dump();
    EXPECT_NE(chart.find("\"specified\""), std::string::npos);
    EXPECT_NE(chart.find("heave, i_c"), std::string::npos);
    erosion::MobilityResult oblique = small_move();
    oblique.direction = {0.8, 0, 0.6};
    EXPECT_EQ(mobility_curves(stories_of(oblique))->chart.dump().find("i_c"), std::string::npos);
    EXPECT_TRUE(explain_figure(figure->id));
    EXPECT_FALSE(mobility_curves({}));
}

TEST(MobilityFigures, RoundNoFactorOfSafetyUpToOne) {
    erosion::MobilityResult mobility = small_move();
    mobility.moves_1 = 0.98 * *mobility.specified_gradient;
    EXPECT_EQ(mobility_curves(stories_of(mobility))->title, "First movement is at 0.98 times the specified gradient");
    EXPECT_EQ(mobility_table(stories_of(mobility))->rows.front()[9], "0.98");
}

TEST(MobilityFigures, MarkWhatWasStillGrowingWhenTheGradientRose) {
    erosion::MobilityResult creeping = small_move();
    creeping.ramp[0].still_moving = 0.1;
    creeping.ramp[1].mobile_mass_share = 0.6;
    creeping.moves_50 = 0.34;
    const auto stories = stories_of(creeping);
    const std::string chart = mobility_curves(stories)->chart.dump();
    EXPECT_NE(chart.find("still growing"), std::string::npos);
    EXPECT_EQ(mobility_table(stories)->rows.front()[4].find("≤ 0.34"), 0U) << mobility_table(stories)->rows.front()[4];
    creeping.moves_1 = 0.05;
    EXPECT_EQ(
        mobility_curves(stories_of(creeping))->title, "First movement is at most 0.50 times the specified gradient"
    );
    EXPECT_EQ(mobility_table(stories_of(creeping))->rows.front()[9], "≤ 0.50");
}

TEST(MobilityFigures, ReportWhichSizesMove) {
    const auto stories = stories_of(small_move());
    const std::optional<Figure> figure = mobile_sizes(study::main_mobility(stories));
    ASSERT_TRUE(figure);
    const std::vector<double>& share = figure->table.numbers("share");
    ASSERT_EQ(share.size(), 4U) << "two sizes at two gradients";
    EXPECT_EQ(share, (std::vector<double>{100, 0, 100, 0}));
    erosion::MobilityResult lifted = small_move();
    lifted.heave_gradient = 0.3;
    const auto below = stories_of(lifted);
    EXPECT_EQ(mobile_sizes(study::main_mobility(below))->table.numbers("share").size(), 2U) << "0.2 alone";
    EXPECT_TRUE(explain_figure(figure->id));
    EXPECT_FALSE(mobile_sizes(nullptr));
}

TEST(MobilityFigures, TabulateEverySoilWithADashWhereTheRampEndsBefore) {
    const std::optional<PageTable> table = mobility_table(stories_of(small_move()));
    ASSERT_TRUE(table);
    ASSERT_EQ(table->rows.size(), 1U);
    EXPECT_EQ(table->rows.front().size(), table->header.size());
    EXPECT_EQ(table->rows.front()[4], "–");
    EXPECT_FALSE(mobility_table({}));
}

} // namespace
} // namespace suffuse::figures
