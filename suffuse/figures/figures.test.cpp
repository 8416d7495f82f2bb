#include "suffuse/figures/figures.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"
#include <algorithm>
#include <set>

namespace suffuse::figures {
namespace {

using erosion::ErosionResult;
using erosion::ProbeResult;
using nlohmann::json;

/// Every field that an encoding or transform of the chart reads.
void fields_in(const json& part, std::set<std::string>& fields) {
    if (part.is_object()) {
        for (const auto& [key, value] : part.items()) {
            if (key == "field" && value.is_string()) {
                fields.insert(value.get<std::string>());
            }
            fields_in(value, fields);
        }
    } else if (part.is_array()) {
        for (const json& each : part) {
            fields_in(each, fields);
        }
    }
}

/// Fields that the chart itself makes: `as` of its transforms, and data of its own.
void made_in(const json& part, std::set<std::string>& fields) {
    if (part.is_object()) {
        if (part.contains("as")) {
            for (const json& name : part["as"].is_array() ? part["as"] : json::array({part["as"]})) {
                fields.insert(name.get<std::string>());
            }
        }
        if (part.contains("values") && part["values"].is_array()) {
            for (const json& row : part["values"]) {
                for (const auto& [key, value] : row.items()) {
                    fields.insert(key);
                }
            }
        }
        for (const auto& [key, value] : part.items()) {
            made_in(value, fields);
        }
    } else if (part.is_array()) {
        for (const json& each : part) {
            made_in(each, fields);
        }
    }
}

TEST(Figures, EachChartReadsOnlyColumnsOfItsOwnTable) {
    for (const Figure& figure : test::sample_figures()) {
        std::set<std::string> read, there;
        fields_in(figure.chart, read);
        made_in(figure.chart, there);
        for (const Column& column : figure.table.columns()) {
            there.insert(column.name);
        }
        for (const std::string& field : read) {
            EXPECT_TRUE(there.contains(field)) << figure.id << " reads " << field;
        }
        EXPECT_GT(figure.table.rows(), 0U) << figure.id;
        EXPECT_FALSE(figure.caption.empty()) << figure.id;
        EXPECT_NE(figure.chart.is_null(), figure.drawing.empty()) << figure.id;
    }
}

TEST(Figures, ClaimsAreShortAndMostFiguresOfARunMakeOne) {
    std::vector<std::string> silent;
    for (const Figure& figure : test::sample_figures()) {
        if (figure.claim.empty()) {
            silent.push_back(figure.id);
        }
        EXPECT_LE(std::ranges::count(figure.claim, ' '), 17) << figure.claim;
        EXPECT_FALSE(figure.claim.ends_with('.')) << figure.claim;
        EXPECT_EQ(figure.claim.find("nan"), std::string::npos) << figure.claim;
    }
    EXPECT_EQ(silent, (std::vector<std::string>{"fig01", "own-paths", "fig07"}))
        << "what was requested, ways, the loop";
}

TEST(Figures, ClaimsSayWhatTheRunFound) {
    ErosionResult erosion = test::sample_erosion();
    erosion.passes.resize(1);
    erosion::PassResult& pass = erosion.passes.front();
    pass.eroded_mass_percent_of_initial = 4.26;
    pass.coordination_histogram = {{0, 1}, {1, 1}, {2, 1}, {3, 1}};
    pass.porosity_before = 0.3;
    pass.porosity_after = 0.31;
    pass.permeability_before = 1e-10;
    pass.permeability_after = 2.5e-10;
    pass.stress_before = diagonal({1e5, 1e5, 1e5});
    pass.stress_constant_volume = diagonal({9e4, 9e4, 9e4});
    EXPECT_EQ(eroded_mass(erosion)->claim, "One pass carried out 4.3 % of the mass");
    EXPECT_EQ(eroded_coordination(erosion)->claim, "50 % of the removed grains had at least two contacts");
    EXPECT_EQ(porosity_path(erosion)->claim, "The porosity rises from 0.3000 to 0.3100");
    EXPECT_EQ(stress_path(erosion)->claim, "Pass 1 costs 10 % of the mean stress at constant volume");
    EXPECT_EQ(permeability_by_pass(erosion)->claim, "The permeability is 2.5 times its initial value");
    pass.eroded_mass_percent_of_initial = 0;
    pass.porosity_after = pass.porosity_before;
    pass.stress_constant_volume = pass.stress_before;
    EXPECT_EQ(eroded_mass(erosion)->claim, "No grain left");
    EXPECT_EQ(porosity_path(erosion)->claim, "The porosity does not change");
    EXPECT_EQ(stress_path(erosion)->claim, "") << "would show only rounding";
}

TEST(Figures, HaveIdsOfTheirOwn) {
    std::set<std::string> ids;
    for (const Figure& figure : test::sample_figures()) {
        EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
    }
}

TEST(Figures, ConstrictionsAreReportedForEachWayOfMergingVoids) {
    ErosionResult erosion = test::sample_erosion();
    const std::string caption = constriction_sizes(erosion)->caption;
    EXPECT_NE(
        caption.find("none 0.448 mm (1,500), center 0.32 mm (600), overlap 0.21 mm (120). Drawn is “none”."),
        std::string::npos
    ) << caption;
    for (erosion::PassResult& pass : erosion.passes) {
        pass.constrictions_by_merge = {}; // as read from a run of before
    }
    EXPECT_EQ(constriction_sizes(erosion)->caption.find("Drawn is"), std::string::npos);
}

TEST(Figures, AnEmptyRunMakesNone) {
    const ErosionResult nothing;
    EXPECT_FALSE(
        erosion_loop(nothing) || speed_by_pass(nothing) || eroded_mass(nothing) || eroded_coordination(nothing)
    );
    EXPECT_FALSE(stress_path(nothing) || porosity_path(nothing) || constriction_sizes(nothing));
    EXPECT_FALSE(
        permeability_by_pass(nothing) || rules_compared({}, {}) || rules_compared({}, {{"", &nothing}}) ||
        speed_by_gradient({})
    );
    EXPECT_FALSE(triaxial_response({}) || eroded_grading({}, nothing) || grading_curves({}, {}, 1e-4));
}

TEST(Figures, APassThatTookNothingStillGivesItsFigures) {
    ErosionResult erosion;
    erosion.passes.emplace_back().pass = 1;
    erosion.passes[0].verdict = {erosion::NothingLeaves{}};
    EXPECT_TRUE(eroded_mass(erosion));
    EXPECT_FALSE(eroded_coordination(erosion));
    ASSERT_TRUE(erosion_loop(erosion));
    EXPECT_NE(erosion_loop(erosion)->caption.find("it stopped because: nothing leaves any more."), std::string::npos);
}

TEST(GradingFigure, SizesAreInMillimetersAndSharesInPercent) {
    const Figure figure = *grading_curves(test::sample_grading(), test::sample_grading(), 2.6e-4);
    const auto& d = figure.table.numbers("diameter");
    EXPECT_NEAR(*std::min_element(d.begin(), d.end()), 0.1, 1e-12);
    EXPECT_NEAR(*std::max_element(d.begin(), d.end()), 0.4, 1e-12);
    EXPECT_NEAR(figure.table.numbers("passing").back(), 100, 1e-12);
    EXPECT_EQ(figure.chart["encoding"]["x"]["scale"]["reverse"], false);
    const Figure reversed = *grading_curves(test::sample_grading(), test::sample_grading(), {}, GradingAxis::Reversed);
    EXPECT_EQ(reversed.chart["encoding"]["x"]["scale"]["reverse"], true);
}

TEST(SpeedFigure, DrawsAtMostTwoHundredGrainsAndKeepsTheExtremes) {
    const ProbeResult probe = test::sample_probe(0.05, 3000, 0.3, 7);
    const Figure figure = *speed_by_gradient({probe});
    std::set<double> drawn;
    for (const double id : figure.table.numbers("grain")) {
        if (std::isfinite(id)) {
            drawn.insert(id);
        }
    }
    EXPECT_EQ(drawn.size(), 200U);
    for (const int group : {0, 1}) {
        std::size_t slowest = 0, fastest = 0;
        double low = 1e9, high = -1;
        for (std::size_t g = 0; g < probe.id.size(); ++g) {
            if (probe.by_velocity[g] != group) {
                continue;
            }
            if (probe.speed[g].back() < low) {
                low = probe.speed[g].back(), slowest = g;
            }
            if (probe.speed[g].back() > high) {
                high = probe.speed[g].back(), fastest = g;
            }
        }
        EXPECT_TRUE(drawn.contains(static_cast<double>(slowest)));
        EXPECT_TRUE(drawn.contains(static_cast<double>(fastest)));
    }
}

TEST(SpeedFigure, RoomThatASmallGroupLeavesGoesToTheOther) {
    ProbeResult probe = test::sample_probe(0.05, 3000, 0.0, 7);
    probe.by_velocity[11] = 1;
    const Figure figure = *speed_by_gradient({probe});
    std::set<double> drawn;
    for (const double id : figure.table.numbers("grain")) {
        if (std::isfinite(id)) {
            drawn.insert(id);
        }
    }
    EXPECT_EQ(drawn.size(), 200U);
    EXPECT_TRUE(drawn.contains(11));
}

TEST(SpeedFigure, ProbesOfOneGradientAndDifferentWatchesKeepTheirOwnPanels) {
    ProbeResult longer = test::sample_probe(0.05, 50, 0.5, 3);
    longer.watch = 10'000;
    const std::vector<ProbeResult> probes = {test::sample_probe(0.05, 50, 0.5, 3), longer, longer};
    const json chart = speed_by_gradient(probes)->chart;
    ASSERT_EQ(chart["facet"]["sort"].size(), 3U);
    EXPECT_EQ(std::set<json>(chart["facet"]["sort"].begin(), chart["facet"]["sort"].end()).size(), 3U);
    EXPECT_EQ(chart["resolve"]["scale"]["x"], "independent");
    EXPECT_EQ(rules_compared(probes, {})->table.rows(), 12U);
    EXPECT_EQ(rules_compared(probes, {})->chart["facet"]["sort"].size(), 3U);
    const ErosionResult erosion = test::sample_erosion();
    const Figure both = *rules_compared({}, {{"first", &erosion}, {"second", &erosion}});
    EXPECT_EQ(both.chart["facet"]["sort"].size(), 2 * erosion.passes.size()); // a panel each, none drawn over another
}

TEST(SpeedFigure, BandsAreTheQuantilesOfAllGrainsOfTheGroup) {
    ProbeResult probe;
    probe.watch = 1000;
    for (std::uint32_t g = 0; g <= 100; ++g) {
        probe.id.push_back(g);
        probe.by_velocity.push_back(1);
        std::array<double, erosion::probe_samples + 1> speed{};
        speed.fill(1e-6 * g);
        probe.speed.push_back(speed);
    }
    const Figure figure = *speed_by_gradient({probe});
    // The first rows are the group's; with ranks 0 to 100 the quantiles are the ranks.
    EXPECT_EQ(figure.table.words("kind").front(), "group");
    EXPECT_NEAR(figure.table.numbers("speed").front(), 50e-6, 1e-15);
    EXPECT_NEAR(figure.table.numbers("speed_10").front(), 10e-6, 1e-15);
    EXPECT_NEAR(figure.table.numbers("speed_90").front(), 90e-6, 1e-15);
}

TEST(SpeedFigure, TheLogAxisSpansWholeDecadesAndAtMostNine) {
    ProbeResult probe = test::sample_probe(0.05, 50, 0.5, 3);
    probe.speed[0].fill(1e-19);
    const json domain = speed_by_gradient({probe})->chart["spec"]["layer"][0]["encoding"]["y"]["scale"]["domain"];
    const double decades = std::log10(domain[1].get<double>() / domain[0].get<double>());
    EXPECT_NEAR(decades, std::round(decades), 1e-9);
    EXPECT_LE(decades, 10);
    for (auto& speed : probe.speed) {
        speed.fill(0);
    }
    EXPECT_TRUE(speed_by_gradient({probe})); // nothing moves: a drawing without lines, not a failure
}

TEST(ErodedGrading, WhatLeftAndWhatRemainsMakeTheWhole) {
    const ErosionResult erosion = test::sample_erosion();
    const Figure figure = *eroded_grading(test::sample_grading(), erosion);
    double eroded = 0;
    for (const erosion::LedgerRow& row : erosion.ledger) {
        eroded += row.mass;
    }
    const double share = eroded / erosion.initial_mass;
    const auto& passing = figure.table.numbers("passing");
    const std::size_t points = passing.size() / 3;
    for (std::size_t k = 0; k < points; ++k) {
        const double before = passing[k], left = passing[points + k], remains = passing[2 * points + k];
        EXPECT_NEAR(share * left + (1 - share) * remains, before, 1e-9); // rounding
    }
    EXPECT_NEAR(passing[2 * points - 1], 100, 1e-9);
    EXPECT_NEAR(passing[3 * points - 1], 100, 1e-9);
}

TEST(ErodedGrading, NeverFallsBelowZeroWhereTheFinestLeave) {
    ErosionResult erosion;
    erosion.initial_mass = 1;
    erosion.ledger = {{.grain = 1, .pass = 1, .diameter = 1.05e-4, .mass = 0.2}};
    const Figure figure = *eroded_grading({{1e-4, 2e-4, 4e-4}, {0, 0.2, 1}, "invented"}, erosion);
    EXPECT_EQ(figure.table.numbers("passing"), (std::vector<double>{0, 20, 100, 0, 100, 100, 0, 0, 100}));
}

TEST(PathFigures, LongPathsAreThinnedButKeepTheEndsOfEachPhase) {
    ErosionResult erosion = test::sample_erosion();
    const erosion::PathRow pattern = erosion.path.back();
    for (int k = 1; k <= 5000; ++k) {
        erosion.path.push_back(pattern);
        erosion.path.back().step += k;
    }
    const Figure figure = *stress_path(erosion);
    EXPECT_LT(figure.table.rows(), 1000U);
    EXPECT_EQ(figure.table.numbers("step").back(), static_cast<double>(erosion.path.back().step));
    EXPECT_EQ(figure.table.words("phase").front(), "before");
}

TEST(PathFigures, StressIsInKilopascalsAndStrainInPercent) {
    const ErosionResult erosion = test::sample_erosion();
    const Table table = stress_path(erosion)->table;
    EXPECT_NEAR(table.numbers("stress_x")[1], 100, 1e-9);
    EXPECT_NEAR(table.numbers("stress_z")[1], 102, 1e-9);
    EXPECT_NEAR(table.numbers("volumetric_strain").back(), 100 * erosion.path.back().volumetric_strain, 1e-15);
}

TEST(PathFigures, WhereNothingChangesWordsStandInThePlaceOfNoise) {
    ErosionResult erosion = test::sample_erosion();
    EXPECT_TRUE(stress_path(erosion)->flat.empty());
    EXPECT_EQ(porosity_path(erosion)->chart["vconcat"].size(), 2U);
    for (erosion::PassResult& pass : erosion.passes) {
        pass.stress_constant_volume = pass.stress_before;
        pass.volumetric_strain = 1e-8;
        pass.porosity_after = pass.porosity_after_removal + 1e-7;
    }
    EXPECT_NE(stress_path(erosion)->flat.find("a hundredth of a percent"), std::string::npos);
    EXPECT_FALSE(stress_path(erosion)->chart.is_null()) << "its numbers are there on request";
    EXPECT_EQ(porosity_path(erosion)->chart["vconcat"].size(), 1U) << "the panel of resettling alone";
    EXPECT_NE(porosity_path(erosion)->caption.find("In no pass did resettling"), std::string::npos);
}

TEST(TwinFigure, ComparesEachFineGrainWithItsMotionWithoutWater) {
    ErosionResult erosion = test::sample_erosion();
    const Figure figure = *compared_with_twin(erosion);
    EXPECT_NE(figure.caption.find("In pass 1 "), std::string::npos) << figure.caption;
    const auto& groups = figure.table.words("group");
    EXPECT_TRUE(std::ranges::find(groups, "detachable, beyond its twin") != groups.end());
    EXPECT_LE(figure.table.rows(), 2U * 500U);
    for (erosion::PassResult& pass : erosion.passes) {
        pass.probe.twin_speed.clear(); // no twin was watched
    }
    EXPECT_FALSE(compared_with_twin(erosion));
}

TEST(PathFigures, TheStateBeforeEachRemovalStandsInFrontOfIt) {
    const ErosionResult erosion = test::sample_erosion();
    const Table table = porosity_path(erosion)->table;
    EXPECT_EQ(table.rows(), erosion.path.size() + 2);
    EXPECT_EQ(table.numbers("eroded_mass").front(), 0);
    EXPECT_NEAR(table.numbers("porosity").front(), erosion.passes[0].porosity_before, 1e-15);
}

TEST(LoopFigure, CountsStandOnTheArrowsAndManyPassesKeepFirstAndLast) {
    ErosionResult erosion = test::sample_erosion();
    erosion.passes[0].detachable = 2778;
    EXPECT_NE(erosion_loop(erosion)->drawing.find(">2,778<"), std::string::npos);
    while (erosion.passes.size() < 9) {
        erosion.passes.push_back(erosion.passes.back());
        erosion.passes.back().pass = static_cast<int>(erosion.passes.size());
    }
    const Figure many = *erosion_loop(erosion);
    EXPECT_NE(many.drawing.find(">pass 1<"), std::string::npos);
    EXPECT_NE(many.drawing.find(">pass 9<"), std::string::npos);
    EXPECT_EQ(many.drawing.find(">pass 5<"), std::string::npos);
    EXPECT_EQ(many.table.columns().size(), 2U + 9U);
}

TEST(LoopFigure, AForcedRemovalUsesNeitherProbeNorConstrictions) {
    ErosionResult erosion = test::sample_erosion();
    erosion.passes[0].probe = {}; // as of a sample without fines
    EXPECT_NE(erosion_loop(erosion)->drawing.find(">–<"), std::string::npos);
    EXPECT_EQ(erosion_loop(erosion)->drawing.find("the removal is forced"), std::string::npos);
    for (erosion::LedgerRow& row : erosion.ledger) {
        row.reason = erosion::Reason::Forced;
    }
    EXPECT_NE(erosion_loop(erosion)->drawing.find("not used: the removal is forced"), std::string::npos);
}

TEST(LoopFigure, CountsFinesWithWeight) {
    ErosionResult erosion = test::sample_erosion();
    erosion.passes.resize(1);
    erosion.passes.front().probe.id.clear();
    erosion.passes.front().mobility.emplace().id.resize(1042);
    EXPECT_NE(erosion_loop(erosion)->drawing.find(">1,042<"), std::string::npos);
    EXPECT_NE(erosion_loop(erosion)->caption.find("among 1,042 fines"), std::string::npos);
}

TEST(RulesFigure, CountsOfEachProbeAddUpToItsFines) {
    const auto probes = test::sample_probes();
    const Figure figure = *rules_compared(probes, {});
    const auto& grains = figure.table.numbers("grains");
    ASSERT_EQ(grains.size(), 16U);
    for (std::size_t p = 0; p < probes.size(); ++p) {
        EXPECT_EQ(grains[4 * p] + grains[4 * p + 1] + grains[4 * p + 2] + grains[4 * p + 3], 950);
    }
}

} // namespace
} // namespace suffuse::figures
