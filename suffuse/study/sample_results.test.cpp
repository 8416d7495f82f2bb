#include "suffuse/study/sample_results.hpp"

#include <gtest/gtest.h>

namespace suffuse::study {
namespace {

/// initial -> first -> second, and another migration from the initial state.
struct Migrations {
    casefile::Study study;
    casefile::Variant variant;
    std::vector<record::FinishedStage> stages;

    explicit Migrations(double fed) {
        const auto add = [&](const char* name, casefile::StageSpec spec, int parent) {
            casefile::Stage stage{.name = name, .spec = std::move(spec)};
            stage.parent = parent;
            variant.stages.push_back(std::move(stage));
        };
        add("initial", packing::CompactSpec{}, -1);
        add("first", erosion::MigrateSpec{}, 0);
        add("other", erosion::MigrateSpec{}, 0);
        add("second", erosion::MigrateSpec{}, 1);
        const auto numbers = [](double eroded, double fed_share, double before, double after) {
            return nlohmann::json{
                {"eroded_share_of_solids", eroded}, {"fed_mass_share", fed_share}, {"permeability_before", before},
                {"permeability_after", after},      {"mean_stress", 1e5},          {"void_ratio", nullptr}};
        };
        const std::vector<nlohmann::json> all = {
            numbers(0, 0, 1, 1), numbers(0.1, fed, 2, 3), numbers(0.4, 0, 2, 9), numbers(0.2, 0, 3, 5)};
        for (std::size_t k = 0; k < variant.stages.size(); ++k) {
            stages.push_back({&study, &variant, &variant.stages[k], all[k], {}});
            if (k > 0) {
                stages.back().findings.migration = erosion::MigrationResult{};
            }
        }
    }

    [[nodiscard]] std::map<Result, double> results() const { return results_of_sample(stages, variant).value; }
};

TEST(SampleResults, OfMigrationsThatFollowEachOtherAreOfAllOfThem) {
    const auto found = Migrations(0).results();
    EXPECT_NEAR(found.at(Result::ErodedMass), 1 - 0.9 * 0.8, 1e-12);
    EXPECT_NEAR(found.at(Result::PermeabilityChange), 2.5, 1e-12);
}

TEST(SampleResults, OfAMigrationEndWhereTheWaterBroughtFines) {
    const auto found = Migrations(0.3).results();
    EXPECT_NEAR(found.at(Result::ErodedMass), 0.1, 1e-12);
    EXPECT_NEAR(found.at(Result::PermeabilityChange), 1.5, 1e-12);
}

TEST(SampleResults, AreUpperBoundsWhereMotionHadNotEnded) {
    for (const bool grew : {false, true}) {
        casefile::Study study;
        casefile::Variant variant;
        casefile::Stage stage{.name = "up", .spec = erosion::DetachStageSpec{}};
        record::FinishedStage finished{&study, &variant, &stage, {{"mean_stress", 1e5}, {"void_ratio", 0.5}}, {}};
        erosion::MobilityResult& mobility = finished.findings.mobility.emplace();
        mobility.ramp = {
            {.gradient = 0.2, .mobile_mass_share = 0.002, .still_moving = grew ? 0.01 : 0},
            {.gradient = 0.4, .mobile_mass_share = 0.2}};
        mobility.moves_1 = erosion::gradient_that_moves(mobility, 0.01), mobility.specified_gradient = 0.1;
        const SampleResults found = results_of_sample({finished}, variant);
        const std::set<Result> both = {Result::Safety, Result::FirstMovement};
        EXPECT_EQ(found.at_most, grew ? both : std::set<Result>{});
        EXPECT_EQ(found.value.at(Result::FirstMovement), *mobility.moves_1);
    }
}

TEST(SampleResults, OfARemovalThatCollapsesHaveNoStrain) {
    for (const bool failed : {false, true}) {
        Migrations sample(0);
        sample.variant.stages[1].spec = erosion::RemoveSpec{};
        sample.stages[1].findings.migration.reset();
        sample.stages[1].numbers.update(
            {{"passes", 1}, {"removed", 5}, {"removed_mass_share", 0.2}, {"volumetric_strain", 0.6}, {"failed", failed}}
        );
        EXPECT_EQ(sample.results().at(Result::RemovedMass), 0.2);
        EXPECT_EQ(sample.results().contains(Result::RemovalStrain), !failed) << "0.6 is where the run stopped";
    }
}

} // namespace
} // namespace suffuse::study
