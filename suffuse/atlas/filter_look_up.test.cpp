#include "suffuse/atlas/filter_look_up.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace suffuse::atlas {
namespace {

FilterRow filter_row(double ratio, double width, double passed, int seed = 1, bool ended = true) {
    FilterRow row;
    row.ratio = ratio, row.width = width, row.seed = seed, row.gradient = 5;
    row.passed = passed, row.ended = ended, row.moving = ended ? 0 : 0.1;
    return row;
}

/// What passes is the logarithm of the ratio over that of 2, in percent, whatever the width.
std::vector<FilterRow> plane_of_filters() {
    std::vector<FilterRow> rows;
    for (const double ratio : {4.0, 8.0}) {
        for (const double width : {1.0001, 4.0}) {
            rows.push_back(filter_row(ratio, width, std::log2(ratio) / 100));
        }
    }
    return rows;
}

TEST(AtlasOfFilters, IsLinearInTheLogarithmsOfRatioAndWidth) {
    const std::vector<FilterFound> found = look_up_filter(plane_of_filters(), std::sqrt(32), 2);
    ASSERT_EQ(found.size(), 1U);
    ASSERT_TRUE(found[0].node);
    EXPECT_EQ(found[0].gradient, 5);
    EXPECT_TRUE(found[0].is_interpolated);
    EXPECT_NEAR(found[0].node->passed.mean, 0.025, 1e-12);
    EXPECT_NEAR(found[0].node->ratio, std::sqrt(32), 1e-9);
    EXPECT_EQ(found[0].node->rows.size(), 4U);
    EXPECT_FALSE(found[0].node->passed.deviation) << "one seed each";
}

TEST(AtlasOfFilters, OutsideItHasTheNearestBaseAndNoAnswer) {
    const std::vector<FilterRow> rows = plane_of_filters();
    for (const auto& [ratio, width, nearest_ratio, nearest_width] :
         {std::tuple(3.0, 2.5, 4.0, 4.0), {20.0, 3.0, 8.0, 4.0}, {7.0, 9.0, 8.0, 4.0}}) {
        const FilterFound found = look_up_filter(rows, ratio, width).front();
        EXPECT_FALSE(found.node) << ratio << " " << width;
        EXPECT_EQ(found.nearest.ratio, nearest_ratio);
        EXPECT_EQ(found.nearest.width, nearest_width);
    }
    EXPECT_TRUE(look_up_filter({}, 4, 1).empty());
}

TEST(AtlasOfFilters, ABaseAtTheEdgeIsInsideWithinTheErrorOfReadSizes) {
    const std::vector<FilterRow> rows = plane_of_filters();
    for (const auto& [ratio, width] : {std::pair(3.97, 2.0), {8.07, 2.0}, {5.0, 4.03}}) {
        EXPECT_TRUE(look_up_filter(rows, ratio, width).front().node) << ratio << " " << width;
    }
    EXPECT_EQ(look_up_filter(rows, 3.97, 4).front().node->ratio, look_up_filter(rows, 4, 4).front().node->ratio);
    EXPECT_FALSE(look_up_filter(rows, 3.95, 2).front().node);
    EXPECT_FALSE(look_up_filter(rows, 8.1, 2).front().node);
}

TEST(AtlasOfFilters, AnErrorOfReadSizesDecidesNothing) {
    std::vector<FilterRow> rows = plane_of_filters(); // of ratios 4 and 8, widths 1 and 4 each
    rows[1].ended = rows[3].ended = false;            // those of width 4
    for (const double width : {1.0, 1.000001, 1.009}) {
        const FilterFound found = look_up_filter(rows, 4, width).front();
        EXPECT_FALSE(found.is_interpolated) << width;
        EXPECT_TRUE(found.node->ended) << width;
        EXPECT_EQ(found.node->rows.size(), 1U) << width;
    }
    EXPECT_FALSE(look_up_filter(rows, 4, 1.1).front().node->ended);

    rows[1].ended =
        true; // now that of ratio 8 alone: off both lines by little more than an error, its weight is 0.03 %
    const FilterFound corner = look_up_filter(rows, 4.05, 1.012).front();
    EXPECT_TRUE(corner.node->ended);
    EXPECT_EQ(corner.node->rows.size(), 3U);
    EXPECT_FALSE(look_up_filter(rows, 6, 1.1).front().node->ended);
}

TEST(AtlasOfFilters, ABaseOfOneSizeCountsAsTheNarrowest) {
    const std::vector<FilterRow> rows = {filter_row(4, 1.2, 0.01), filter_row(8, 1.2, 0.02)};
    EXPECT_TRUE(look_up_filter(rows, 5, 1).front().node);
    EXPECT_FALSE(look_up_filter(rows, 5, 1.3).front().node);
}

TEST(AtlasOfFilters, SeedsGiveAMeanAndItsScatterAndOneThatMovesMakesItABound) {
    const std::vector<FilterRow> rows = {filter_row(4, 1, 0.01), filter_row(4, 1, 0.05, 2, false)};
    const FilterFound found = look_up_filter(rows, 4, 1).front();
    ASSERT_TRUE(found.node);
    EXPECT_FALSE(found.is_interpolated);
    EXPECT_NEAR(found.node->passed.mean, 0.03, 1e-15);
    EXPECT_NEAR(found.node->passed.deviation.value(), 0.04 / std::sqrt(2), 1e-15);
    EXPECT_NEAR(found.node->moving, 0.05, 1e-15);
    EXPECT_FALSE(found.node->ended);
}

TEST(AtlasOfFilters, EachGradientHasItsOwnAnswer) {
    std::vector<FilterRow> rows = {filter_row(4, 1, 0.01), filter_row(4, 1, 0.05)};
    rows[0].gradient = 20;
    const std::vector<FilterFound> found = look_up_filter(rows, 4, 1);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].gradient, 5);
    EXPECT_EQ(found[1].node->passed.mean, 0.01);
}

TEST(AtlasOfFilters, ItsErrorIsThatOfNodesWhichAreLeftOut) {
    const std::vector<FilterRow> rows = {filter_row(2, 1, 0), filter_row(4, 1, 0.3), filter_row(8, 1, 0.2)};
    EXPECT_NEAR(error_of_filters(rows, 5).value(), 0.2, 1e-12);
    EXPECT_FALSE(error_of_filters(rows, 1)) << "no rows";
    EXPECT_FALSE(error_of_filters(plane_of_filters(), 5)) << "no node has a neighbor on either side";
}

TEST(AtlasOfFilters, ABrokenLineIsNamed) {
    const std::string header =
        "ratio,width,seed,gradient,grains,thickness,constriction,passed,moving,ended,entered,overlap\n";
    EXPECT_EQ(parse_filter_rows(header + "3,1.15,2,5,800,1.4,0.4,0.02,0.01,1,0.2,0.03\n").front().seed, 2);
    for (const char* const line : {"3,1.15\n", "3,1.15,2,5,800,1.4,0.4,much,0.01,1,0.2,0.03\n"}) {
        try {
            parse_filter_rows(header + line);
            ADD_FAILURE() << line;
        } catch (const CaseError& error) {
            EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
        }
    }
}

TEST(AtlasOfFilters, RowsThatAreShippedAreConsistent) {
    std::set<std::tuple<double, double, int, double>> keys;
    ASSERT_FALSE(shipped_filter_rows().empty());
    for (const FilterRow& row : shipped_filter_rows()) {
        EXPECT_TRUE(keys.emplace(row.ratio, row.width, row.seed, row.gradient).second);
        EXPECT_TRUE(row.ratio > 1 && row.width > 1);
        EXPECT_GT(row.thickness, 1);
        EXPECT_TRUE(row.constriction > 0.1 && row.constriction < 1) << row.constriction;
        for (const double share : {row.passed, row.moving, row.entered}) {
            EXPECT_TRUE(share >= 0 && share <= 1) << share;
        }
    }
}

} // namespace
} // namespace suffuse::atlas
