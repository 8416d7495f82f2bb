#include "suffuse/figures/figures_sweep.hpp"

#include "suffuse/figures/figure_guide.hpp"

#include <gtest/gtest.h>

namespace suffuse::figures {
namespace {

using study::Result;

study::StudyOutcome swept(const std::vector<std::pair<std::string, std::vector<double>>>& points) {
    study::StudyOutcome outcome;
    outcome.keys = {"stage.initial.friction"};
    for (const auto& [written, of_seed] : points) {
        study::OutcomePoint point;
        point.at.written = {written};
        point.at.value = {0};
        point.samples.resize(of_seed.size(), nullptr);
        point.result[Result::ErodedMass] = study::scatter_of(of_seed);
        outcome.points.push_back(std::move(point));
    }
    return outcome;
}

TEST(SweepFigure, HasMeanBandAndEverySampleOverTheValuesAsWritten) {
    const Figure figure = sweep_result(swept({{"10 deg", {0.01, 0.03}}, {"30 deg", {0.10, 0.14}}})).value();
    EXPECT_EQ(figure.table.numbers("value"), (std::vector<double>{10, 10, 30, 30}));
    const std::vector<double> samples = {1, 3, 10, 14};
    for (std::size_t k = 0; k < samples.size(); ++k) {
        EXPECT_DOUBLE_EQ(figure.table.numbers("sample")[k], samples[k]);
    }
    EXPECT_DOUBLE_EQ(figure.table.numbers("mean")[2], 12);
    EXPECT_NEAR(figure.table.numbers("high")[2] - 12, std::sqrt(8), 1e-12); // deviation of 10 and 14
    EXPECT_EQ(figure.chart["layer"][0]["mark"]["type"], "area");
    EXPECT_EQ(figure.chart["layer"][0]["encoding"]["x"]["title"], "friction [deg]");
    EXPECT_NE(figure.caption.find("one standard deviation"), std::string::npos);
    EXPECT_TRUE(explain_figure(figure.id));
}

TEST(SweepFigure, SaysAtHowManyPointsTheValueIsAnUpperBound) {
    study::StudyOutcome outcome = swept({{"0.05", {0.01}}, {"2", {0.10}}});
    EXPECT_EQ(sweep_result(outcome).value().caption.find("upper bound"), std::string::npos);
    outcome.points.back().at_most.insert(Result::ErodedMass);
    EXPECT_NE(sweep_result(outcome).value().caption.find("At 1 of 2 points motion had not ended"), std::string::npos);
}

TEST(SweepFigure, OverNumbersWithoutAUnitHasNoneInItsTitle) {
    const Figure figure = sweep_result(swept({{"0.05", {0.01}}, {"2", {0.10}}})).value();
    EXPECT_EQ(figure.table.numbers("value"), (std::vector<double>{0.05, 2}));
    EXPECT_EQ(figure.chart["layer"][0]["encoding"]["x"]["title"], "friction");
}

TEST(SweepFigure, OverWordsHasBarsInsteadOfALineBetweenThem) {
    const Figure figure = sweep_result(swept({{"random", {0.01}}, {"smallest", {0.10}}})).value();
    EXPECT_EQ(figure.chart["layer"][0]["mark"]["type"], "rule");
    EXPECT_EQ(figure.table.words("value").front(), "random");
    EXPECT_NE(figure.caption.find("One sample per point"), std::string::npos);
}

TEST(SweepFigure, SaysOfHowManyPointsAndSamplesItIs) {
    study::StudyOutcome outcome = swept({{"10 deg", {0.10, 0.14}}, {"20 deg", {0.11, 0.13, 0.15}}, {"30 deg", {0}}});
    outcome.points.back().result.clear();
    outcome.keys.emplace_back("gradient");
    for (study::OutcomePoint& point : outcome.points) {
        point.at.written.emplace_back("0.1");
    }
    const Figure figure = sweep_result(outcome).value();
    EXPECT_EQ(figure.title, "Mass carried out: no measurable difference over the friction and gradient");
    EXPECT_NE(figure.caption.find("mean of 2 to 3 samples."), std::string::npos) << figure.caption;
    EXPECT_NE(figure.caption.find("2 of 3 points have a result."), std::string::npos) << figure.caption;
    EXPECT_EQ(
        sweep_result(swept({{"10 deg", {0.120}}, {"20 deg", {0.124}}}))->title,
        "Mass carried out: nearly the same over the friction"
    );
}

TEST(SweepFigure, IsNoneWithoutASweepOrAResult) {
    EXPECT_FALSE(sweep_result(swept({{"10 deg", {0.01}}})));
    study::StudyOutcome nothing = swept({{"10 deg", {0.01}}, {"20 deg", {0.02}}});
    for (study::OutcomePoint& point : nothing.points) {
        point.result.clear();
    }
    EXPECT_FALSE(sweep_result(nothing));
    EXPECT_FALSE(sweep_multiples(swept({{"10 deg", {0.01}}, {"20 deg", {0.02}}}))) << "one result is no multiple";
}

TEST(SweepFigure, ShowsItsOtherResultsSideBySide) {
    study::StudyOutcome outcome = swept({{"10 deg", {0.01}}, {"20 deg", {0.02}}});
    for (study::OutcomePoint& point : outcome.points) {
        point.result[Result::VoidRatio] = study::scatter_of({0.7});
        point.result[Result::Strength] = study::scatter_of({3e5});
        point.result[Result::StressChange] = study::scatter_of({-2e-6}); // noise of the balance: no panel
    }
    const Figure figure = sweep_multiples(outcome).value();
    EXPECT_EQ(figure.chart["facet"]["sort"].size(), 2U);
    EXPECT_EQ(figure.table.rows(), 4U);
}

} // namespace
} // namespace suffuse::figures
