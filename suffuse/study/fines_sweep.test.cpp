#include "suffuse/study/fines_sweep.hpp"

#include <gtest/gtest.h>

namespace suffuse::study {
namespace {

casefile::Stage compaction(const std::string& name, std::vector<casefile::Scalar> only = {}) {
    casefile::Stage stage;
    stage.name = name;
    stage.spec = packing::CompactSpec{};
    if (!only.empty()) {
        stage.only = {{"fines_content", std::move(only)}};
    }
    return stage;
}

SweepPoint at(double content, double void_ratio) {
    SweepPoint point;
    point.value = {content};
    point.written = {std::to_string(content)};
    point.seed = {1};
    point.number["void_ratio"] = scatter_of({void_ratio});
    return point;
}

/// A study whose loose state is made by "light" up to FC 10 %, by "heavy" beyond, next to a dense one.
struct TwoLooseStages {
    casefile::Case what;
    std::vector<StudyCurves> traced;

    TwoLooseStages() {
        casefile::Study study;
        study.name = "s";
        casefile::Stage dense = compaction("dense");
        std::get<packing::CompactSpec>(dense.spec).prepare.friction = 0;
        study.stages = {compaction("light", {"0 %", "10 %"}), compaction("heavy", {"30 %", "20 %"}), dense};
        what.studies = {study};
        StudyCurves curves{"s", {"fines_content"}, 1, {}};
        curves.stages.push_back({"light", {at(0, 0.9), at(0.1, 0.8)}});
        curves.stages.push_back({"heavy", {at(0.3, 0.5), at(0.2, 0.6)}});
        curves.stages.push_back({"dense", {at(0, 0.6), at(0.1, 0.5), at(0.2, 0.4), at(0.3, 0.45)}});
        traced = {curves};
    }
};

TEST(FinesSweep, AStateWithoutADenserOneIsNotCalledLoose) {
    const StageCurve none, dense{"dense", {at(0, 0.6)}};
    EXPECT_EQ(name_of_loose({"poured", {at(0, 0.9)}}, dense), "loose state");
    EXPECT_EQ(name_of_loose({"smooth", {at(0, 0.9)}}, none), "state “smooth”");
}

TEST(FinesSweep, ALooseStateMadeByTwoStagesIsOneCurve) {
    const TwoLooseStages made;
    const std::optional<FinesSweep> sweep = find_fines_sweep(made.what, made.traced);
    ASSERT_TRUE(sweep);
    EXPECT_EQ(sweep->loose_stages, (std::vector<std::string>{"light", "heavy"}));
    EXPECT_EQ(sweep->dense, "dense");
    EXPECT_EQ(sweep->curves.fines_content, (std::vector<double>{0, 0.1, 0.2, 0.3}));
    std::vector<double> void_ratio;
    for (const SweepPoint& point : loose_points(*sweep).points) {
        void_ratio.push_back(point.number.at("void_ratio").mean);
    }
    EXPECT_EQ(void_ratio, (std::vector<double>{0.9, 0.8, 0.6, 0.5}));
    EXPECT_EQ(sweep->curves.dense.points.at(2).number.at("void_ratio").mean, 0.4);
}

TEST(FinesSweep, NamesTheValuesOfOtherKeysThatItsCurvesAreOf) {
    TwoLooseStages made;
    EXPECT_EQ(other_values(find_fines_sweep(made.what, made.traced).value()), "");
    made.traced.front().keys = {"fines_content", "stage.light.friction"};
    for (StageCurve& stage : made.traced.front().stages) {
        for (SweepPoint& point : stage.points) {
            point.written.emplace_back("30 deg"), point.value.push_back(0.5);
        }
    }
    EXPECT_EQ(other_values(find_fines_sweep(made.what, made.traced).value()), "friction 30 deg");
}

TEST(FinesSweep, AStageOfAllFinesContentsIsALooseStateByItself) {
    TwoLooseStages made;
    made.what.studies[0].stages[0].only.clear();
    const std::optional<FinesSweep> sweep = find_fines_sweep(made.what, made.traced);
    ASSERT_TRUE(sweep);
    EXPECT_EQ(sweep->loose_stages, std::vector<std::string>{"light"});
    EXPECT_EQ(sweep->curves.fines_content, (std::vector<double>{0, 0.1}));
}

} // namespace
} // namespace suffuse::study
