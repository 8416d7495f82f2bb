#include "suffuse/answer/surrogate_words.hpp"

#include "suffuse/answer/mobility_words.hpp"
#include "suffuse/grains/surrogate.hpp"

#include <gtest/gtest.h>

#include <list>

namespace suffuse::answer {
namespace {

using study::MobilityStory;

/// A fifth of it fines, with medians of 0.02 and 2 mm.
const grains::Grading silty_gravel{{0.005e-3, 0.08e-3, 1e-3, 4e-3}, {0, 0.2, 0.2, 1}, "gravel"};

erosion::MobilityResult moved_at(double moves_1, std::optional<double> moves_10) {
    erosion::MobilityResult mobility;
    mobility.down = {0, 0, -1};
    mobility.direction = {0, 0, 1};
    mobility.ramp = {{.gradient = 0.2, .mobile_mass_share = 0.002}, {.gradient = 1.2, .mobile_mass_share = 0.2}};
    mobility.moves_1 = moves_1, mobility.moves_10 = moves_10;
    mobility.id = {1}, mobility.mass = {1}, mobility.diameter = {1}, mobility.mobile_gradient = {0.3};
    mobility.bears_load = {0};
    return mobility;
}

/// One stage of a study over the size ratio.
class Surrogates : public testing::Test {
protected:
    Surrogates() {
        study_.name = "surrogate", study_.replicates = 1;
        study_.sweep = {{"size_ratio", {4.0, 10.0}}};
    }

    void add(double ratio, const erosion::MobilityResult& mobility) {
        casefile::Variant variant;
        variant.values["size_ratio"] = ratio;
        variant.soil = grains::surrogate_of(silty_gravel, {.finer_than = 0.3e-3, .size_ratio = ratio});
        variants_.push_back(variant);
        stages_.push_back({&study_, &variants_.back(), &stage_, nlohmann::json::object(), {}});
        stages_.back().findings.mobility = mobility;
    }

    casefile::Study study_;
    casefile::Stage stage_{.name = "upward", .spec = erosion::DetachStageSpec{}};
    std::list<casefile::Variant> variants_;
    std::vector<record::FinishedStage> stages_;
};

TEST_F(Surrogates, TheFirstSentenceNamesThem) {
    add(100, moved_at(0.3, 0.5));
    const std::vector<MobilityStory> stories = study::gather_mobility(stages_);
    EXPECT_EQ(verdict(stories.front()).find("By a surrogate, upward flow moves 1 %"), 0U) << verdict(stories.front());
    EXPECT_EQ(short_verdict(stories.front()).front().find("By a surrogate, upward flow moves 1 %"), 0U);
    EXPECT_TRUE(verdict_by_ratio(stories).empty()) << "which is of several ratios";
}

TEST_F(Surrogates, OfSeveralRatiosTheVerdictShowsTheTrendAndCallsTheSoilsOwnAnExtrapolation) {
    add(4, moved_at(0.41, 0.6)), add(10, moved_at(0.22, std::nullopt));
    EXPECT_EQ(
        verdict_by_ratio(study::gather_mobility(stages_)),
        (std::vector<std::string>{
            "By a surrogate, upward flow moves 1 % of the fines at i = 0.41 and 0.22 at size ratios of 4 and 10.",
            "It moves a tenth at 0.60 and more than 1.20.",
            "The soil's ratio is 100: its own gradients are an extrapolation. Above 6.5 single fines may sift through "
            "the skeleton without flow; at 10 less than 0.1 % of their mass did."})
    );
}

TEST_F(Surrogates, OfTwoSweptKeysNoSeriesPoolsTheValuesOfTheOther) {
    study_.sweep.push_back({"friction", {0.4, 0.5}});
    for (const double friction : {0.4, 0.5}) {
        for (const double ratio : {4.0, 10.0}) {
            add(ratio, moved_at(friction, std::nullopt));
            variants_.back().values["friction"] = friction;
        }
    }
    const std::vector<MobilityStory> stories = study::gather_mobility(stages_);
    EXPECT_TRUE(verdict_by_ratio(stories).empty());
    EXPECT_EQ(nearest_surrogate(stories)->moves_1.mean, 0.4) << "of the reported friction";
}

TEST_F(Surrogates, WhatNoRatioReachesIsNotRepeated) {
    add(4, moved_at(0.41, std::nullopt)), add(10, moved_at(0.22, std::nullopt));
    EXPECT_EQ(verdict_by_ratio(study::gather_mobility(stages_))[1], "It moves less than a tenth up to i = 1.20.");
}

TEST_F(Surrogates, NoGradientIsClaimedBeyondHeaveNorThatOfOneSampleOfThree) {
    erosion::MobilityResult reached = moved_at(0.41, 0.6), still = moved_at(0, std::nullopt);
    reached.heave_gradient = 1.05, still.heave_gradient = 1.13;
    still.moves_1.reset();
    erosion::MobilityResult odd = still;
    odd.moves_1 = 0.9, odd.moves_10 = 1.1;
    add(4, reached);
    const auto variant = variants_.size();
    for (const erosion::MobilityResult& sample : {odd, still, still}) {
        add(10, sample);
    }
    EXPECT_EQ(variants_.size(), variant + 3);
    std::vector<std::string> lines = verdict_by_ratio(study::gather_mobility(stages_));
    EXPECT_NE(lines[0].find("at i = 0.41 and none below heave (1.13) at"), std::string::npos) << lines[0];
    EXPECT_EQ(lines[1], "It moves a tenth at 0.60 and none below heave (1.13).");
    stages_.front().findings.mobility = still;
    lines = verdict_by_ratio(study::gather_mobility(stages_));
    EXPECT_NE(lines[0].find("moves less than 1 % of the fines below heave at size ratios of 4"), std::string::npos)
        << lines[0];
    EXPECT_EQ(lines[1], "It moves less than a tenth below heave.");
}

TEST_F(Surrogates, TheVerdictHasBothFlowsInThreeLines) {
    const casefile::Stage level{.name = "level", .spec = erosion::DetachStageSpec{}};
    for (const double ratio : {4.0, 10.0}) {
        add(ratio, moved_at(0.41, 0.6));
        add(ratio, moved_at(0.1, 0.3));
        stages_.back().stage = &level;
        stages_.back().findings.mobility->direction = {1, 0, 0};
    }
    const std::vector<std::string> lines = verdict_by_ratio(study::gather_mobility(stages_));
    ASSERT_EQ(lines.size(), 3U) << "no more are shown";
    EXPECT_EQ(lines[0].find("By a surrogate, upward flow moves 1 %"), 0U);
    EXPECT_NE(lines[1].find("an extrapolation"), std::string::npos);
    EXPECT_EQ(lines[2], "Level flow moves 1 % at 0.10 and 0.10.");
}

TEST_F(Surrogates, TheTableHasBothSoilsAndWhatIsLeftOut) {
    add(4, moved_at(0.41, 0.6)), add(10, moved_at(0.22, std::nullopt));
    const auto table = tabulate_surrogate(study::gather_mobility(stages_));
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rows[1], (std::vector<std::string>{"fines content by mass", "20 %", "20 %"}));
    EXPECT_EQ(table->rows[2], (std::vector<std::string>{"size ratio D50/d50 [-]", "100", "4 and 10"}));
    EXPECT_EQ(table->rows[4][1], "3") << "D90/D10 of a part that is log-uniform over a factor of 4: its 0.8th power";
    for (const char* const what : {"width", "shape", "density", "size ratio of 100", "Cohesion"}) {
        EXPECT_NE(table->note.find(what), std::string::npos) << what;
    }
}

TEST_F(Surrogates, AWidthThatWasNotMeasuredIsUnknown) {
    grains::Grading open = silty_gravel;
    open.passing.front() = 0.05;
    const grains::Soil soil = grains::surrogate_of(open, {.finer_than = 0.3e-3});
    EXPECT_NE(left_out_of(soil, soil.surrogate->size_ratio).front().find("unknown in the fines"), std::string::npos);
    EXPECT_EQ(left_out_of(soil, soil.surrogate->size_ratio).size(), 4U) << "its own ratio is simulated";
    open.diameter.front() = 0.07e-3;
    const std::string cohesion = left_out_of(grains::surrogate_of(open, {.finer_than = 0.3e-3}), 100).back();
    EXPECT_EQ(
        cohesion.find("Cohesion: up to 5.0 % of the mass may be finer than 0.063 mm (the curve ends at 0.07 mm)"), 0U
    ) << cohesion;
}

TEST_F(Surrogates, ASoilOfItsOwnHasNone) {
    add(4, moved_at(0.41, 0.6));
    variants_.back().soil->surrogate.reset();
    const std::vector<MobilityStory> stories = study::gather_mobility(stages_);
    EXPECT_EQ(subject_of(stories.front()), "Upward flow");
    EXPECT_FALSE(tabulate_surrogate(stories));
}

} // namespace
} // namespace suffuse::answer
