#include "suffuse/job/atlas_words.hpp"

#include "suffuse/atlas/rows_for_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace suffuse::job {
namespace {

using atlas::Row;
using atlas::test::row_at;

/// Two fractions, each a factor of 1.1/0.9 wide, with D50/d50 = 5.
grains::Grading gap_of(double fines) {
    return {{0.18e-3, 0.22e-3, 0.9e-3, 1.1e-3}, {0, fines, fines, 1}, "gap"};
}

stability::AssessSpec spec_at(double gradient, std::optional<stability::FlowWay> flow = {}) {
    stability::AssessSpec spec;
    spec.seepage = stability::Seepage{.gradient = gradient, .flow = flow};
    return spec;
}

Row level(Row row) {
    row.flow = atlas::Flow::Level, row.heave.reset();
    row.moves_1.gradient = *row.moves_1.gradient / 4, row.moves_10.gradient = *row.moves_10.gradient / 4;
    return row;
}

Row dense(Row row) {
    row.density = atlas::Density::Dense;
    row.moves_1.gradient = *row.moves_1.gradient + 0.05;
    return row;
}

/// Ratios of 4 and 6.25, on either side of 5, with i_c = 1.
std::vector<Row> atlas_around_five() {
    std::vector<Row> rows;
    for (const double ratio : {4.0, 6.25}) {
        for (const double fines : {0.1, 0.2}) {
            const Row loose = row_at(ratio, fines, 0.2);
            rows.insert(rows.end(), {loose, level(loose), dense(loose), level(dense(loose))});
        }
    }
    return rows;
}

AtlasWords words_of(const std::vector<Row>& rows, double fines, const stability::AssessSpec& spec) {
    return atlas_words(consult_atlas(gap_of(fines), spec, rows), *spec.seepage);
}

bool has(const std::vector<std::string>& notes, const std::string& part) {
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(AtlasAnswer, ALineForEachDensityHasBothFlows) {
    const AtlasWords words = words_of(atlas_around_five(), 0.15, spec_at(0.3));
    EXPECT_EQ(words.heading.find("atlas of simulated soils: D50/d50 5, 15 % of fines (split at 0.22 mm"), 0U)
        << words.heading;
    ASSERT_TRUE(words.table);
    EXPECT_EQ(
        words.table->rows[0], (std::vector<std::string>{"loose", "0.39", "0.15", "0.20", "0.40", "0.05", "0.10"})
    );
    EXPECT_EQ(words.table->rows[1].front(), "dense");
    EXPECT_EQ(
        words.notes[0],
        "at i = 0.3, of the mass of the fines: upward flow moves 1 to 10 % (loose and dense); level flow "
        "moves 10 % or more (loose and dense)"
    );
    EXPECT_TRUE(has(words.notes, "scatter not known: one seed"));
    EXPECT_TRUE(has(words.notes, "unknown")) << "no node can be left out of four";
    EXPECT_FALSE(has(words.notes, "fall through"));
}

TEST(AtlasAnswer, OneFlowAloneIsGivenWhereItIsSpecified) {
    const AtlasWords words = words_of(atlas_around_five(), 0.15, spec_at(0.3, stability::level_flow));
    EXPECT_EQ(words.table->header.size(), 5U);
    EXPECT_EQ(words.table->rows[0][3], "0.05");
    const AtlasWords down = words_of(atlas_around_five(), 0.15, spec_at(0.3, stability::downward));
    EXPECT_FALSE(down.table);
    EXPECT_NE(down.heading.find("none downward"), std::string::npos) << down.heading;
}

TEST(AtlasAnswer, OutsideNoShareIsPromisedAndTheNearestSoilIsNamed) {
    const AtlasWords words = words_of(atlas_around_five(), 0.3, spec_at(0.3));
    EXPECT_EQ(words.heading.find("outside the atlas"), 0U) << words.heading;
    EXPECT_TRUE(has(words.notes, "the atlas has D50/d50 4 to 6.25 and 10 to 20 % of fines"));
    EXPECT_TRUE(has(words.notes, "of its nearest soil"));
    EXPECT_FALSE(has(words.notes, "flow moves"));
}

TEST(AtlasAnswer, BoundsSiftingAndScatterAreReported) {
    std::vector<Row> rows = atlas_around_five();
    for (const Row& row : atlas_around_five()) {
        Row other = row;
        other.seed = 2, other.moves_1.gradient = *row.moves_1.gradient * 1.2;
        rows.push_back(other);
    }
    rows.front().moves_1.is_at_most = true, rows.front().sifting = 0.04;
    const AtlasWords words = words_of(rows, 0.15, spec_at(0.1));
    EXPECT_EQ(words.table->rows[0][3], "<= 0.22");
    EXPECT_TRUE(has(words.notes, "an unknown share (loose), less than 1 % (dense)")) << words.notes[0];
    // 0.2 and 0.24: a deviation of 0.028 about 0.22
    EXPECT_TRUE(has(words.notes, "scatter among 2 samples: upward 13 % and 0 %")) << words.notes[1];
    EXPECT_TRUE(has(words.notes, "fall through the skeleton by themselves: up to 4 % of their mass (loose)"));
}

TEST(AtlasAnswer, AGradientThatOnlySomeSamplesReachedIsALowerBound) {
    std::vector<Row> rows;
    for (const double ratio : {4.0, 6.25}) {
        for (const double fines : {0.1, 0.2}) {
            rows.push_back(row_at(ratio, fines, 0.25));
        }
    }
    rows.back().moves_1.gradient.reset(), rows.back().moves_10.gradient.reset();
    const stability::AssessSpec spec = spec_at(0.3, stability::upward);
    const AtlasWords words = words_of(rows, 0.15, spec);
    EXPECT_EQ(words.table->rows[0][3], ">= 0.35"); // a quarter of the corners at i_c = 1
    EXPECT_EQ(words.table->rows[0][4], ">= 0.59");
    EXPECT_TRUE(has(words.notes, "upward flow moves less than 1 % (loose)")) << words.notes[0];
    EXPECT_TRUE(has(words_of(rows, 0.15, spec_at(0.4, stability::upward)).notes, "an unknown share (loose)"));
    const auto entry = atlas_json(consult_atlas(gap_of(0.15), spec, rows), spec)[0];
    EXPECT_TRUE(entry["i1"].is_null());
    EXPECT_NEAR(entry["lower_bounds"]["i1"].get<double>(), std::sqrt(std::sqrt(0.25 * 0.25 * 0.25)), 1e-12);

    rows.front().moves_1.is_at_most = true;
    EXPECT_EQ(words_of(rows, 0.15, spec).table->rows[0][3], "not known");
    for (Row& row : rows) {
        row.moves_1 = {}, row.moves_10 = {};
    }
    const AtlasWords none = words_of(rows, 0.15, spec);
    EXPECT_EQ(none.table->rows[0][3], "not reached");
    EXPECT_TRUE(has(none.notes, "upward flow moves less than 1 % (loose)")) << "as the ramps went up to i_c";
}

TEST(AtlasAnswer, CallsItsGradientsTooHighForWideFines) {
    const grains::Grading wide{{0.1e-3, 0.4e-3, 0.9e-3, 1.1e-3}, {0, 0.15, 0.15, 1}, "wide"};
    const stability::AssessSpec spec = spec_at(0.3);
    const AtlasAnswer answer = consult_atlas(wide, spec, atlas_around_five());
    EXPECT_TRUE(has(atlas_words(answer, *spec.seepage).notes, "too high for this soil: its fines are wide (d90/d10 3)")
    );
    EXPECT_EQ(atlas_json(answer, spec)[0]["wide_fines"], true);
    EXPECT_FALSE(has(words_of(atlas_around_five(), 0.15, spec).notes, "too high"));
}

TEST(AtlasAnswer, ASoilWithoutAnUnstableSplitHasNoParts) {
    const grains::Grading uniform{{0.9e-3, 1.1e-3}, {0, 1}, "uniform"};
    const stability::AssessSpec spec = spec_at(0.3);
    const AtlasAnswer answer = consult_atlas(uniform, spec, atlas_around_five());
    EXPECT_FALSE(answer.parts);
    EXPECT_NE(atlas_words(answer, *spec.seepage).heading.find("no split of this curve is unstable"), std::string::npos);
    EXPECT_TRUE(atlas_json(answer, spec).empty());
}

TEST(AtlasAnswer, JsonHasAnObjectForEachDensityAndFlowWithNullsOutside) {
    const stability::AssessSpec spec = spec_at(0.3);
    const auto inside = atlas_json(consult_atlas(gap_of(0.15), spec, atlas_around_five()), spec);
    ASSERT_EQ(inside.size(), 4U);
    EXPECT_EQ(inside[0]["inside"], true);
    EXPECT_EQ(inside[0]["rows"].size(), 4U);
    EXPECT_NEAR(inside[0]["i1_over_ic"].get<double>(), 0.2, 1e-12);
    EXPECT_NEAR(inside[0]["alpha"].get<double>(), 0.15, 1e-12);
    const auto outside = atlas_json(consult_atlas(gap_of(0.3), {}, atlas_around_five()), {});
    ASSERT_EQ(outside.size(), 4U) << "without seepage too";
    EXPECT_EQ(outside[0]["inside"], false);
    for (const char* const key : {"alpha", "i1_over_ic", "i10_over_ic", "i1", "i10"}) {
        EXPECT_TRUE(outside[0][key].is_null()) << key;
    }
    EXPECT_EQ(outside[0]["rows"][0]["fines"], 0.2);
}

TEST(AtlasAnswer, HeavierGrainsNeedSteeperGradients) {
    stability::AssessSpec spec = spec_at(0.3);
    spec.seepage->grain_density = 4300; // twice the buoyant weight
    const AtlasWords words = words_of(atlas_around_five(), 0.15, spec);
    EXPECT_EQ(words.table->rows[0][3], "0.40");
}

} // namespace
} // namespace suffuse::job
