#include "suffuse/study/erosion_story.hpp"

#include "suffuse/study/findings_by_seed.hpp"
#include "suffuse/study/joined_passes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::study {
namespace {

/// Ten grains of 1 g at first; `removed` leave in each pass.
erosion::ErosionResult erosion_of(double initial_mass, std::vector<std::int64_t> removed, double porosity) {
    erosion::ErosionResult result;
    result.initial_mass = initial_mass;
    double left = initial_mass;
    for (const std::int64_t grains : removed) {
        erosion::PassResult pass;
        pass.pass = static_cast<int>(result.passes.size()) + 1;
        pass.removed = grains;
        pass.coordination_histogram = {{0, grains}};
        pass.eroded_mass_percent_of_initial = 100 * static_cast<double>(grains) * 1e-3 / initial_mass;
        pass.porosity_before = pass.porosity_after_removal = pass.porosity_after = porosity;
        pass.probe.id = {1};
        left -= static_cast<double>(grains) * 1e-3;
        erosion::PathRow row;
        row.pass = pass.pass, row.step = 10 * pass.pass, row.volumetric_strain = 0.01 * pass.pass;
        row.eroded_mass = 1 - left / initial_mass;
        result.path.push_back(row);
        erosion::LedgerRow gone;
        gone.pass = pass.pass;
        result.ledger.push_back(gone);
        result.passes.push_back(pass);
    }
    return result;
}

/// initial -> first -> unloaded -> second, and another erosion from the initial state.
struct TwoStages {
    casefile::Study study;
    casefile::Variant variant;
    std::vector<record::FinishedStage> stages;

    TwoStages() {
        const auto add = [&](const char* name, casefile::StageSpec spec, int parent) {
            casefile::Stage stage{.name = name, .spec = std::move(spec)};
            stage.parent = parent;
            variant.stages.push_back(std::move(stage));
        };
        add("initial", packing::CompactSpec{}, -1);
        add("first", erosion::ErodeSpec{}, 0);
        add("unloaded", casefile::StageSpec{packing::CompactSpec{}}, 1);
        add("other", erosion::ErodeSpec{}, 0);
        add("second", erosion::ErodeSpec{}, 2);
        for (const casefile::Stage& stage : variant.stages) {
            stages.push_back({&study, &variant, &stage, {}, {}});
        }
        stages[1].findings.erosion = erosion_of(10e-3, {2, 1}, 0.4);
        stages[3].findings.erosion = erosion_of(10e-3, {3}, 0.4);
        stages[4].findings.erosion = erosion_of(7e-3, {1}, 0.45);
    }
};

TEST(ErosionStory, StagesThatFollowEachOtherAreOneAndTheRestAreOthers) {
    const TwoStages sample;
    const ErosionStory story = find_story(sample.stages);
    EXPECT_EQ(story.chain, (Erosions{&sample.stages[1], &sample.stages[4]}));
    EXPECT_EQ(story.others, (Erosions{&sample.stages[3]}));
    ASSERT_EQ(story.erosion.passes.size(), 3U);
    ASSERT_EQ(story.made_in.size(), 3U);
    EXPECT_EQ(story.made_in[2].stage, &sample.stages[4]);
    EXPECT_EQ(story.made_in[2].number, 1);
    EXPECT_FALSE(story.made_in[0].is_last);
    EXPECT_TRUE(story.made_in[1].is_last);
}

TEST(ErosionStory, JoinedPassesCountOnAndMassesAreOfTheFirstState) {
    const TwoStages sample;
    const erosion::ErosionResult joined = find_story(sample.stages).erosion;
    double percent = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(joined.passes[k].pass, static_cast<int>(k) + 1);
        EXPECT_EQ(joined.ledger[k].pass, static_cast<int>(k) + 1);
        percent += joined.passes[k].eroded_mass_percent_of_initial;
    }
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(percent, 40, rounding) << "4 of 10 grains";
    EXPECT_NEAR(joined.path.back().eroded_mass, 0.4, rounding) << "4 of 10 grains";
    EXPECT_EQ(joined.path.back().step, 30);
    // The same grains filled 1 - 0.4 of the volume, and 1 - 0.45 of it when unloaded.
    EXPECT_NEAR(joined.path.back().volumetric_strain, 0.02 + std::log(0.55 / 0.6) + 0.01, rounding);
}

TEST(ErosionStory, OneStageIsAChainOfItself) {
    TwoStages sample;
    sample.stages.resize(2);
    EXPECT_EQ(find_story(sample.stages).chain, (Erosions{&sample.stages[1]}));
    EXPECT_EQ(find_story(sample.stages).erosion.passes.size(), 2U);
    EXPECT_TRUE(find_story({}).chain.empty());
}

TEST(ErosionStory, EachWayToALastErosionIsAReading) {
    TwoStages sample;
    sample.study.variants = {sample.variant};
    for (record::FinishedStage& stage : sample.stages) {
        stage.variant = sample.study.variants.data();
        stage.stage = &stage.variant->stages[static_cast<std::size_t>(&stage - sample.stages.data())];
    }
    const std::vector<Reading> readings = judge_readings(sample.stages);
    ASSERT_EQ(readings.size(), 2U);
    EXPECT_EQ(readings[0].name, "other");
    EXPECT_EQ(readings[1].name, "first, then second");
    for (const Reading& reading : readings) {
        EXPECT_EQ(reading.findings.size(), 7U);
    }
    EXPECT_NE(readings[0].findings[3].ours.find("no pass 2"), std::string::npos);
    EXPECT_NE(readings[1].findings[3].ours.find("0 of 1"), std::string::npos) << readings[1].findings[3].ours;
    EXPECT_TRUE(judge_readings({}).empty());
}

} // namespace
} // namespace suffuse::study
