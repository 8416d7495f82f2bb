#include "suffuse/figures/figures_filter.hpp"

#include <gtest/gtest.h>

namespace suffuse::figures {
namespace {

/// A base of two slices on a filter of four; a third of its finer half got through.
MigrationCurve stack(const std::string& name) {
    MigrationCurve curve{name, {.fines_mass = 1}};
    erosion::MigrationResult& result = curve.result;
    result.rows = {{.time = 0.5, .permeability = 1e-9}};
    result.holds = {{.gradient = 5, .ended = true, .eroded_mass_share = 0.16, .entered_mass_share = 0.3}};
    result.profile = {
        .first = -1e-3,
        .step = 0.5e-3,
        .filter = {0, 0, 0.6, 0.5, 0.6, 0.5},
        .base = {{0.6, 0.5, 0, 0, 0, 0}, {0.6, 0.2, 0.1, 0, 0, 0}}};
    result.filter = {
        .filter_d15 = 1e-3,
        .base_d85 = 0.2e-3,
        .constriction = 0.18e-3,
        .before =
            {.width = 2e-3,
             .along = {-0.5e-3, 1e-3},
             .across = {1e-3, 0.5e-3},
             .radius = {1e-4, 4e-4},
             .is_base = {1, 0}},
        .after = {.width = 2e-3, .along = {1e-3}, .across = {0.5e-3}, .radius = {4e-4}, .is_base = {0}},
        .sizes = {.diameter = {1e-4, 2e-4}, .mass_share = {0.5, 0.5}, .entered = {0.5, 0.1}, .eroded = {0.32, 0}}};
    return curve;
}

TEST(FilterFigures, HaveTheProfilesInTheMiddlesOfTheirSlices) {
    const auto figure = filter_profile({stack("s")});
    ASSERT_TRUE(figure);
    ASSERT_EQ(figure->table.rows(), 18U);
    EXPECT_EQ(figure->table.words("what")[0], "filter");
    EXPECT_DOUBLE_EQ(figure->table.numbers("depth")[0], -0.75);
    EXPECT_DOUBLE_EQ(figure->table.numbers("solid")[2], 60);
    EXPECT_EQ(figure->table.words("what")[13], "base at the end");
    EXPECT_DOUBLE_EQ(figure->table.numbers("solid")[13], 20);
    EXPECT_NE(figure->caption.find("16 % of the base passed, and 30 % went beyond the interface"), std::string::npos);
}

TEST(FilterFigures, DrawACircleForEachGrainThatIsCutInItsPlaceAndSize) {
    const auto figure = filter_cut({stack("s")});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.rows(), 3U);
    std::size_t circles = 0;
    for (std::size_t at = figure->drawing.find("<circle"); at != std::string::npos;
         at = figure->drawing.find("<circle", at + 1)) {
        ++circles;
    }
    EXPECT_EQ(circles, 3U);
    // 260 pixels are 2 mm; the first begins 16 pixels from the left and 46 from the top, 1.5 mm before the filter.
    EXPECT_NE(figure->drawing.find(R"(<svg x="16.0" y="46.0")"), std::string::npos) << figure->drawing;
    EXPECT_NE(figure->drawing.find(R"(<circle cx="130.0" cy="130.0" r="13.0" fill="#c8322b"/>)"), std::string::npos);
    EXPECT_NE(figure->drawing.find(R"(<circle cx="65.0" cy="325.0" r="52.0" fill="#b5852f"/>)"), std::string::npos);
    EXPECT_NE(figure->drawing.find(R"(M16.0 241.0H276.0)"), std::string::npos) << "the interface";
    MigrationCurve wide = stack("s");
    wide.result.filter.after.across.front() = 0.1e-3; // it reaches over the side
    EXPECT_NE(filter_cut({wide})->drawing.find(R"(<circle cx="273.0" cy="325.0" r="52.0")"), std::string::npos);
}

TEST(FilterFigures, HaveTheShareOfEachSizeAndTheControllingConstriction) {
    const auto figure = filter_sizes({stack("s")});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.numbers("size"), (std::vector<double>{0.1, 0.2, 0.1, 0.2}));
    EXPECT_EQ(figure->table.numbers("share"), (std::vector<double>{50, 10, 32, 0}));
    EXPECT_NE(figure->caption.find("is 0.18 mm for s."), std::string::npos) << figure->caption;
}

TEST(FilterFigures, AreOfTheFirstStacksAlone) {
    MigrationCurve one_soil = stack("no stack");
    one_soil.result.profile = {};
    one_soil.result.filter = {};
    EXPECT_FALSE(filter_profile({one_soil}) || filter_cut({one_soil}) || filter_sizes({one_soil}));
    std::vector<MigrationCurve> many{one_soil};
    for (int k = 0; k < 9; ++k) {
        many.push_back(stack("s" + std::to_string(k)));
    }
    EXPECT_EQ(filter_profile(many)->chart["facet"]["sort"].size(), 6U);
    EXPECT_EQ(filter_sizes(many)->chart["facet"]["sort"].size(), 6U);
    EXPECT_EQ(filter_cut(many)->table.rows(), 9U) << "three of three circles";
}

} // namespace
} // namespace suffuse::figures
