#include "suffuse/figures/stress_probes.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include <set>

namespace suffuse::figures {
namespace {

/// As many directions as there are normalized works; strains in proportion to their number.
study::ProbedState state_of(const std::vector<double>& works) {
    study::ProbedState state;
    state.name = "probed";
    for (std::size_t k = 0; k < works.size(); ++k) {
        const auto number = static_cast<double>(k);
        const double angle = 2 * pi * number / static_cast<double>(works.size());
        state.directions.push_back({angle, works[k], 1e3, 2e3, 1e-4 * number, 2e-4 * number, works[k] <= 0 ? 1 : 0});
    }
    return state;
}

TEST(StressProbes, AStableStateIsReportedAsStable) {
    EXPECT_EQ(
        describe_stability(state_of({0.9, 1, 0.25, 0.8})),
        "probed: stable in all 4 directions of load; the least normalized second-order work is 0.25 at 180°."
    );
}

TEST(StressProbes, UnstableDirectionsAreNamedAsRanges) {
    study::ProbedState broken = state_of({0.9, -0.1, -0.2, 0.8, 0, 0.7, 0.6, 0.5});
    broken.directions.back().unstable = 1; // it failed, though its work was above zero
    EXPECT_EQ(
        describe_stability(broken),
        "probed: not stable in 4 of 8 directions of load (45° to 90°, 180°, 315°); the least "
        "normalized second-order work is −0.2 at 90°."
    );
}

TEST(StressProbes, OfSeveralSamplesTheUnstableOnesAreCounted) {
    study::ProbedState seeds = state_of({0.9, 0.8, -0.1, 0.7});
    seeds.samples = 3;
    seeds.directions[2].unstable = 2;
    EXPECT_EQ(
        describe_stability(seeds), "probed: not stable in 1 of 4 directions of load (180°; 2 of 3 samples); the least "
                                   "normalized second-order work is −0.1 at 180°, on the mean."
    );
}

TEST(StressProbes, TheCurveOfAStateIsClosedAndItsStrainsAreInPercent) {
    const Figure figure = *stability_in_directions({state_of({0.9, 1, 0.25, 0.8}), state_of({1, 1, 1, 1})});
    const std::vector<double>& angle = figure.table.numbers("angle");
    ASSERT_EQ(angle.size(), 10U);
    EXPECT_DOUBLE_EQ(angle[4], 360);
    EXPECT_DOUBLE_EQ(figure.table.numbers("normalized_work")[4], 0.9);
    EXPECT_DOUBLE_EQ(figure.table.numbers("lateral_strain")[1], 0.02);
    EXPECT_DOUBLE_EQ(figure.table.numbers("axial_stress")[1], 1);
    EXPECT_FALSE(stability_in_directions({}).has_value());
}

TEST(StressProbes, WhatIsShownNextToAPointIsInTheTable) {
    const Figure figure = *stability_in_directions({state_of({0.9, 1, 0.25, 0.8})});
    std::set<std::string> columns;
    for (const Column& column : figure.table.columns()) {
        columns.insert(column.name);
    }
    for (const nlohmann::json& field : figure.chart["hconcat"][1]["encoding"]["tooltip"]) {
        EXPECT_TRUE(columns.contains(field.at("field"))) << field;
    }
}

} // namespace
} // namespace suffuse::figures
