#include "suffuse/atlas/look_up.hpp"

#include "suffuse/atlas/interpolation_error.hpp"
#include "suffuse/atlas/rows_for_tests.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::atlas {
namespace {

using test::row_at;

Found look_up_loose(const std::vector<Row>& rows, double ratio, double fines) {
    return look_up(rows, ratio, fines, Density::Loose, Flow::Up);
}

/// i1 = fines / ratio^2: a plane in the logarithms of i1 and of the ratio, along each line of fines.
std::vector<Row> square() {
    std::vector<Row> rows;
    for (const double ratio : {4.0, 8.0}) {
        for (const double fines : {0.1, 0.2}) {
            rows.push_back(row_at(ratio, fines, fines / (ratio * ratio)));
        }
    }
    return rows;
}

TEST(Atlas, AtANodeTheNodeIsTheAnswer) {
    const Found found = look_up_loose(square(), 8, 0.2);
    ASSERT_TRUE(found.node);
    EXPECT_NEAR(found.node->moves_1->mean, 0.2 / 64, 1e-15);
    EXPECT_NEAR(found.node->moves_10->mean, 0.4 / 64, 1e-15);
    EXPECT_NEAR(found.node->alpha.mean, 0.2, 1e-15);
    EXPECT_FALSE(found.is_interpolated);
    EXPECT_EQ(found.rows.size(), 1U);
}

TEST(Atlas, WithinACellItIsLinearInFinesAndTheLogarithmOfTheRatio) {
    const Found found = look_up_loose(square(), std::sqrt(32), 0.15);
    ASSERT_TRUE(found.node);
    EXPECT_TRUE(found.is_interpolated);
    EXPECT_EQ(found.rows.size(), 4U);
    EXPECT_NEAR(found.node->moves_1->mean, std::sqrt(0.1 * 0.2) / 32, 1e-15);
    EXPECT_NEAR(found.node->alpha.mean, 0.15, 1e-15);
}

TEST(Atlas, OnALineOnlyItsNodesAreNeeded) {
    std::vector<Row> rows = square();
    rows.pop_back(); // ratio 8, 20 %
    EXPECT_TRUE(look_up_loose(rows, 4, 0.15).node);
    EXPECT_TRUE(look_up_loose(rows, 6, 0.1).node);
    EXPECT_FALSE(look_up_loose(rows, 6, 0.15).node) << "a corner is missing";
}

TEST(Atlas, OutsideItNamesTheNearestRowsAndNoNumber) {
    const Found found = look_up_loose(square(), 20, 0.05);
    EXPECT_FALSE(found.node);
    ASSERT_EQ(found.rows.size(), 1U);
    EXPECT_EQ(found.rows.front().size_ratio, 8);
    EXPECT_EQ(found.rows.front().fines_content, 0.1);
    EXPECT_TRUE(look_up(square(), 4, 0.1, Density::Dense, Flow::Up).rows.empty()) << "none of this density";
}

TEST(Atlas, ASingleRatioAnswersOnlyForSoilsOfThatRatio) {
    const std::vector<Row> rows = {row_at(6.5, 0.1, 0.2), row_at(6.5, 0.2, 0.3)};
    EXPECT_TRUE(look_up_loose(rows, 6.65, 0.12).node);
    EXPECT_TRUE(look_up_loose(rows, 6.35, 0.12).node);
    EXPECT_FALSE(look_up_loose(rows, 6.8, 0.12).node);
    EXPECT_FALSE(look_up_loose(rows, 6.2, 0.12).node);
}

TEST(Atlas, SeedsGiveAMeanAndItsScatterAndOneSeedNone) {
    const std::vector<Row> rows = {row_at(4, 0.1, 0.2), row_at(4, 0.1, 0.4, 2), row_at(4, 0.2, 0.3)};
    const Found two = look_up_loose(rows, 4, 0.1), one = look_up_loose(rows, 4, 0.15);
    EXPECT_EQ(two.seeds(), 2);
    EXPECT_NEAR(two.node->moves_1->mean, 0.3, 1e-15);
    EXPECT_NEAR(two.node->moves_1->deviation.value(), 0.2 / std::sqrt(2), 1e-15);
    EXPECT_EQ(one.seeds(), 1) << "of the node with the fewest";
    EXPECT_FALSE(one.node->moves_1->deviation);
}

TEST(Atlas, GradientsOfSoilsOfOtherPorositiesAreComparedOverTheirHeave) {
    Row level = row_at(4, 0.1, 0.2);
    level.flow = Flow::Level, level.heave.reset(), level.porosity = 0.5;
    const Found found = look_up({level}, 4, 0.1, Density::Loose, Flow::Level);
    EXPECT_NEAR(found.node->moves_1->mean, 0.2 / (1.65 * 0.5), 1e-15);
}

TEST(Atlas, AnUpperBoundStaysOneAndAGradientThatWasNotReachedIsNone) {
    std::vector<Row> rows = square();
    rows[0].moves_1.is_at_most = true;
    rows[3].moves_10.gradient.reset();
    const Found inside = look_up_loose(rows, 6, 0.15);
    EXPECT_TRUE(inside.node->moves_1->is_at_most);
    EXPECT_FALSE(inside.node->moves_10);
    EXPECT_FALSE(inside.node->least_1.gradient) << "it has an upper bound alone";
    EXPECT_FALSE(look_up_loose(rows, 4, 0.2).node->moves_1->is_at_most) << "another node";
    EXPECT_TRUE(look_up_loose(rows, 4, 0.2).node->moves_10);
}

TEST(Atlas, WhereOneNodeDidNotReachAGradientItIsAtLeastWhatTheRampsSay) {
    std::vector<Row> rows = {row_at(4, 0.1, 0.25), row_at(4, 0.2, 0.2)}; // i_c = 1 ends the ramp before 1.2
    rows[1].moves_1.gradient.reset();
    const Node between = *look_up_loose(rows, 4, 0.15).node, reached = *look_up_loose(rows, 4, 0.1).node;
    EXPECT_FALSE(between.moves_1);
    EXPECT_TRUE(between.least_1.is_reached);
    EXPECT_NEAR(between.least_1.gradient.value(), std::sqrt(0.25 * 1), 1e-12);
    EXPECT_NEAR(reached.least_1.gradient.value(), 0.25, 1e-12);
    rows[0].moves_1.gradient.reset();
    rows[0].heave = 2; // then 1.2 does
    const Node nowhere = *look_up_loose(rows, 4, 0.15).node;
    EXPECT_FALSE(nowhere.least_1.is_reached);
    EXPECT_NEAR(nowhere.least_1.gradient.value(), std::sqrt(0.6), 1e-12);
    rows[0].flow = Flow::Level, rows[0].heave.reset();
    EXPECT_DOUBLE_EQ(last_gradient(rows[0]), 0.9);
}

TEST(Atlas, OfSamplesOfOneNodeThatDidNotAllReachAGradientTheMeanIsAFloor) {
    std::vector<Row> rows = {row_at(4, 0.1, 0.2), row_at(4, 0.1, 0.4, 2)};
    rows[0].moves_1.gradient.reset();
    const Node node = *look_up_loose(rows, 4, 0.1).node;
    EXPECT_FALSE(node.moves_1);
    EXPECT_TRUE(node.least_1.is_reached);
    EXPECT_NEAR(node.least_1.gradient.value(), (1 + 0.4) / 2, 1e-12);
    rows[1].moves_1.is_at_most = true;
    EXPECT_FALSE(look_up_loose(rows, 4, 0.1).node->least_1.gradient) << "bounds to both sides bound nothing";
}

TEST(Atlas, ANodeWhoseWeightIsWithinReadingErrorsBoundsNothing) {
    std::vector<Row> rows = square(); // fines contents of 10 and 20 %
    for (const std::size_t twenty : {1, 3}) {
        rows[twenty].moves_1.is_at_most = true, rows[twenty].moves_10.gradient.reset();
    }
    const Found near = look_up_loose(rows, 4, 0.1005), far = look_up_loose(rows, 4, 0.105);
    EXPECT_FALSE(near.node->moves_1->is_at_most);
    EXPECT_NEAR(near.node->moves_10->mean, 0.2 / 16, 1e-12) << "that of the node with a number";
    EXPECT_EQ(near.rows.size(), 1U);
    EXPECT_TRUE(far.node->moves_1->is_at_most);
    EXPECT_FALSE(far.node->moves_10);
    EXPECT_EQ(far.rows.size(), 2U);
}

TEST(Atlas, AGradientOfZeroLeavesNumbers) {
    const Found found = look_up_loose({row_at(4, 0.1, 0), row_at(4, 0.2, 0.3)}, 4, 0.15);
    EXPECT_TRUE(std::isfinite(found.node->moves_1->mean));
}

TEST(Atlas, ItsErrorIsThatOfNodesWhichAreLeftOut) {
    // the middle one of three is e^0.5 times what its neighbors say: predicted too low by a factor of e^0.5
    const std::vector<Row> rows = {row_at(4, 0.1, 0.1), row_at(4, 0.2, 0.1 * std::exp(0.5)), row_at(4, 0.3, 0.1)};
    const InterpolationError error = error_of_interpolation(rows, Flow::Up);
    EXPECT_NEAR(error.moves_1.value(), 1 - std::exp(-0.5), 1e-12);
    EXPECT_NEAR(error.moves_10.value(), 1 - std::exp(-0.5), 1e-12);
    EXPECT_FALSE(error_of_interpolation(rows, Flow::Level).moves_1) << "no rows";
    EXPECT_FALSE(error_of_interpolation(square(), Flow::Up).moves_1) << "no node has a neighbor on either side";
}

TEST(Atlas, ALogarithmicLineOverTheRatioHasNoError) {
    const std::vector<Row> rows = {row_at(4, 0.1, 1. / 4), row_at(6, 0.1, 1. / 6), row_at(10, 0.1, 1. / 10)};
    EXPECT_NEAR(error_of_interpolation(rows, Flow::Up).moves_1.value(), 0, 1e-12);
}

TEST(Atlas, KnowsWhichDensitiesItHas) {
    EXPECT_EQ(densities_of(square(), Flow::Up), std::vector<Density>{Density::Loose});
    EXPECT_TRUE(densities_of(square(), Flow::Level).empty());
}

} // namespace
} // namespace suffuse::atlas
