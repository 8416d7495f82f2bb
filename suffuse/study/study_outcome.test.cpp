#include "suffuse/study/study_outcome.hpp"

#include "suffuse/study/sample_results.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::study {
namespace {

/// A study of two values and two seeds each, every sample eroded.
struct SweptStudy {
    casefile::Case what;
    std::vector<record::FinishedStage> stages;

    SweptStudy() {
        casefile::Study& study = what.studies.emplace_back();
        study.name = "dam";
        study.sweep = {{"gradient", {0.2, 0.1}}};
        study.stages = {
            {.name = "initial", .spec = packing::CompactSpec{}}, {.name = "erosion", .spec = erosion::ErodeSpec{}}};
        for (const double gradient : {0.2, 0.1}) {
            for (const int replicate : {1, 2}) {
                casefile::Variant variant;
                variant.folder = "dam/x";
                variant.values = {{"gradient", gradient}};
                variant.replicate = replicate;
                variant.seed = static_cast<std::uint64_t>(replicate);
                variant.stages = study.stages;
                variant.stages[1].parent = 0;
                study.variants.push_back(std::move(variant));
            }
        }
        for (const casefile::Variant& variant : study.variants) {
            const double gradient = std::get<double>(variant.values.at("gradient"));
            stages.push_back(
                {&study, &variant, &variant.stages[0], {{"mean_stress", 1e5}, {"void_ratio", 0.6}, {"grains", 10}}, {}}
            );
            erosion::ErosionResult erosion;
            for (const int pass : {1, 2}) {
                erosion::PassResult& result = erosion.passes.emplace_back();
                result.pass = pass;
                result.eroded_mass_percent_of_initial = 50 * gradient + variant.replicate;
                result.permeability_before = 1e-11, result.permeability_after = 3e-11;
            }
            stages.push_back(
                {&study, &variant, &variant.stages[1], {{"mean_stress", 1e5}, {"void_ratio", 0.8}, {"grains", 9}}, {}}
            );
            stages.back().findings.erosion = std::move(erosion);
        }
    }
};

TEST(StudyOutcome, IsMeanAndDeviationOverTheSeedsAtEachValueInItsOrder) {
    const SweptStudy swept;
    const std::vector<StudyOutcome> outcomes = gather_outcomes(swept.what, swept.stages);
    ASSERT_EQ(outcomes.size(), 1U);
    const StudyOutcome& outcome = outcomes.front();
    ASSERT_EQ(outcome.points.size(), 2U);
    EXPECT_EQ(outcome.samples(), 4U);
    EXPECT_EQ(outcome.seeds(), 2U);
    EXPECT_EQ(outcome.points[0].at.value, std::vector<double>{0.1});
    const Scatter& eroded = *outcome.points[0].find(Result::ErodedMass);
    EXPECT_NEAR(eroded.mean, 0.13, 1e-15);                          // two passes of 5 + 1 % and 5 + 2 %, rounding
    EXPECT_NEAR(eroded.standard_deviation, std::sqrt(2e-4), 1e-15); // of 12 and 14 %
    EXPECT_NEAR(outcome.points[1].find(Result::ErodedMass)->mean, 0.23, 1e-15);
    EXPECT_NEAR(outcome.points[0].find(Result::PermeabilityChange)->mean, 3, 1e-15);
    EXPECT_EQ(outcome.points[0].find(Result::VoidRatio)->mean, 0.6) << "before water, not after";
    EXPECT_EQ(outcome.points[0].find(Result::Safety), nullptr);
    EXPECT_EQ(main_outcome(outcomes), &outcome);
    EXPECT_EQ(main_result(outcome), Result::ErodedMass);
    EXPECT_TRUE(depends_on_sweep(outcome, Result::ErodedMass));
    EXPECT_FALSE(depends_on_sweep(outcome, Result::VoidRatio));
}

TEST(StudyOutcome, ReportsAResultThatTheSweepChangesBeforeOneThatItDoesNot) {
    StudyOutcome outcome;
    outcome.keys = {"gradient"};
    for (const double value : {1.0, 2.0}) {
        OutcomePoint& point = outcome.points.emplace_back();
        point.at.value = {value};
        point.result[Result::ErodedMass] = scatter_of({0.1});
        point.result[Result::Strength] = scatter_of({1e5 * value});
    }
    EXPECT_EQ(main_result(outcome), Result::Strength);
    outcome.points[1].result[Result::Strength] = scatter_of({1e5});
    EXPECT_EQ(main_result(outcome), Result::ErodedMass) << "none changes: the one that answers most";
    EXPECT_FALSE(main_result(StudyOutcome{}));
}

TEST(StudyOutcome, DependsOnTheSweepBeyondFivePercentAndTwoDeviations) {
    const auto depends = [](const std::vector<double>& at_first, const std::vector<double>& at_last) {
        StudyOutcome outcome;
        for (const std::vector<double>& of_seed : {at_first, at_last}) {
            outcome.points.emplace_back().result[Result::Strength] = scatter_of(of_seed);
        }
        return depends_on_sweep(outcome, Result::Strength);
    };
    EXPECT_FALSE(depends({1e5}, {0.951e5}));
    EXPECT_TRUE(depends({1e5}, {0.949e5}));
    const double apart = 1e4 * std::sqrt(0.5); // of two seeds that deviate by 10 kPa
    EXPECT_FALSE(depends({1e5 - apart, 1e5 + apart}, {1.19e5}));
    EXPECT_TRUE(depends({1e5 - apart, 1e5 + apart}, {1.21e5}));
}

TEST(StudyOutcome, CountsThePointsThatTheCaseHas) {
    SweptStudy swept;
    swept.stages.resize(4); // of the first value
    const std::vector<StudyOutcome> outcomes = gather_outcomes(swept.what, swept.stages);
    EXPECT_EQ(outcomes.front().points.size(), 1U);
    EXPECT_EQ(outcomes.front().all_points(), 2U);
    EXPECT_EQ(outcomes.front().points.front().erosion->most_passes, 2);
}

TEST(StudyOutcome, LeavesOutSamplesThatFailedBeforeTheyHadAResult) {
    SweptStudy swept;
    for (std::size_t k = 0; k < swept.stages.size(); k += 2) { // of the first value both, of the second one
        if (k != 4) {
            swept.stages[k].numbers["mean_stress"] = nullptr;
            swept.stages[k + 1].findings.erosion.reset();
        }
    }
    const StudyOutcome outcome = gather_outcomes(swept.what, swept.stages).front();
    EXPECT_EQ(outcome.points.size(), 1U);
    EXPECT_EQ(outcome.samples(), 1U);
    EXPECT_EQ(outcome.points.front().at.seed, std::vector<std::uint64_t>{1});
    EXPECT_EQ(outcome.all_points(), 2U);
    EXPECT_TRUE(outcome.has(Result::ErodedMass));
}

TEST(StudyOutcome, FirstMovementsAreOfOneStageAlsoWhereOnlyAnotherMoves) {
    SweptStudy swept;
    const casefile::Study& study = swept.what.studies.front();
    const casefile::Stage level{.name = "level", .spec = erosion::DetachStageSpec{}}, upward{.name = "upward"};
    for (const casefile::Variant& variant : study.variants) {
        for (const casefile::Stage* stage : {&level, &upward}) {
            const bool moves = stage == &upward || std::get<double>(variant.values.at("gradient")) == 0.2;
            swept.stages.push_back({&study, &variant, stage, {{"mean_stress", 1e5}, {"void_ratio", 0.6}}, {}});
            erosion::MobilityResult& mobility = swept.stages.back().findings.mobility.emplace();
            mobility.moves_1 = moves ? std::optional(stage == &level ? 0.3 : 0.4) : std::nullopt;
        }
    }
    const StudyOutcome outcome = gather_outcomes(swept.what, swept.stages).front();
    EXPECT_EQ(outcome.first_probe, "level");
    EXPECT_EQ(outcome.points[1].find(Result::FirstMovement)->mean, 0.3);
    EXPECT_EQ(outcome.points[0].find(Result::FirstMovement), nullptr) << "0.4 is of another stage";
}

TEST(StudyOutcome, ASweepOfSingleSamplesIsNeverWithinScatter) {
    const auto effect = [](const std::vector<double>& at_first, const std::vector<double>& at_last) {
        StudyOutcome outcome;
        for (const std::vector<double>& of_seed : {at_first, at_last, std::vector<double>{}}) {
            OutcomePoint& point = outcome.points.emplace_back();
            if (!of_seed.empty()) {
                point.result[Result::Strength] = scatter_of(of_seed);
            }
        }
        const SweepEffect found = effect_of_sweep(outcome, Result::Strength);
        EXPECT_EQ(found.points, 2U);
        return found.difference;
    };
    EXPECT_EQ(effect({1e5}, {1e5}), Difference::Small);
    EXPECT_EQ(effect({1e5, 1.02e5}, {1e5, 1.03e5}), Difference::WithinScatter);
    EXPECT_EQ(effect({1e5, 1.0001e5}, {1.03e5, 1.0301e5}), Difference::Small);
    EXPECT_EQ(effect({1e5}, {2e5}), Difference::Clear);
}

TEST(StudyOutcome, ASweepIsJudgedByTheDifferencesOfSamplesOfOneSeed) {
    const auto effect = [](const std::vector<double>& at_first, const std::vector<double>& at_last,
                           std::vector<std::uint64_t> seeds_at_last) {
        StudyOutcome outcome;
        outcome.points.resize(2);
        outcome.points[0].at.seed = {1, 2, 3};
        outcome.points[1].at.seed = std::move(seeds_at_last);
        outcome.points[0].result[Result::Strength] = scatter_of(at_first);
        outcome.points[1].result[Result::Strength] = scatter_of(at_last);
        return effect_of_sweep(outcome, Result::Strength).difference;
    };
    // Samples differ by more than the sweep changes, but each is changed alike.
    EXPECT_EQ(effect({1e5, 1.3e5, 1.6e5}, {1.1e5, 1.41e5, 1.69e5}, {1, 2, 3}), Difference::Clear);
    EXPECT_EQ(effect({1e5, 1.3e5, 1.6e5}, {1.1e5, 1.41e5, 1.69e5}, {4, 5, 6}), Difference::WithinScatter)
        << "no pairs: twice the deviation of single samples";
    // 1, -1 and 3 more: 1 ± 2, a standard error of 1.15, times Student's 2.92.
    EXPECT_EQ(effect({1e5, 1e5, 1e5}, {1.1e5, 0.9e5, 1.3e5}, {1, 2, 3}), Difference::WithinScatter);
    EXPECT_EQ(effect({1e5, 1e5, 1e5}, {1.4e5, 1.2e5, 1.6e5}, {1, 2, 3}), Difference::Clear) << "4 ± 2";
    EXPECT_EQ(effect({1e5, 1.3e5, std::nan("")}, {1.1e5, 1.9e5, 5e5}, {1, 2, 3}), Difference::WithinScatter)
        << "two pairs, 1 and 6, by Student's 6.31";
}

TEST(StudyOutcome, KeysWithOneLastWordAreDistinguishedByTheirStages) {
    const std::vector<std::string> keys = {
        "stage.initial.pressure", "stage.second.pressure", "contact.rolling_friction"};
    EXPECT_EQ(key_in_words(keys[0], keys), "stage.initial.pressure");
    EXPECT_EQ(key_in_words(keys[2], keys), "rolling friction");
    EXPECT_EQ(key_in_words(keys[0]), "pressure");
}

TEST(StudyOutcome, SamplesAgreeWhereTheirNumbersHaveTheSameBits) {
    EXPECT_TRUE(agree(scatter_of({0.1, 0.1, 0.1}))) << "though the mean of three is rounded";
    EXPECT_FALSE(agree(scatter_of({0.1, 0.1 + 1e-15})));
    EXPECT_FALSE(agree(scatter_of({0.1})));
}

TEST(StudyOutcome, EveryResultHasAScale) {
    for (int k = 0; k < results; ++k) {
        EXPECT_GT(scale_of(static_cast<Result>(k)).factor, 0);
    }
    EXPECT_EQ(key_in_words("stage.initial.prepare_friction"), "prepare friction");
}

TEST(PermeabilityAfter, IsKnownToBeTooHighWhereTheNetworkFails) {
    erosion::ErosionResult erosion;
    EXPECT_FALSE(permeability_after(erosion, flow::Conductance::Bounded));
    erosion::PassResult& pass = erosion.passes.emplace_back();
    pass.permeability_before = 1e-11, pass.permeability_after = 3e-11;
    pass.porosity_after = 0.5; // a solid fraction of 0.5, below the 0.55 from which Yade's law is too permeable
    EXPECT_FALSE(permeability_after(erosion, flow::Conductance::Bounded)->after_is_too_high);
    EXPECT_TRUE(permeability_after(erosion, flow::Conductance::Yade)->after_is_too_high);
    pass.porosity_after = 0.449;
    EXPECT_FALSE(permeability_after(erosion, flow::Conductance::Yade)->after_is_too_high);
    pass.porosity_after = 0.451;
    EXPECT_TRUE(permeability_after(erosion, flow::Conductance::Yade)->after_is_too_high);
    pass.flow_after.raised_by_fines = 1.2;
    EXPECT_TRUE(permeability_after(erosion, flow::Conductance::Bounded)->after_is_too_high);
    pass.flow_after.is_limited = true; // to what the coarse grains alone let through
    EXPECT_FALSE(permeability_after(erosion, flow::Conductance::Bounded)->after_is_too_high);
    pass.flow_after.solver = flow::Solver::Resolved;
    EXPECT_FALSE(permeability_after(erosion, flow::Conductance::Yade)->after_is_too_high);
}

} // namespace
} // namespace suffuse::study
