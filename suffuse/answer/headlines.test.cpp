#include "suffuse/answer/headlines.hpp"

#include "suffuse/answer/samples_table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"
#include <cmath>

namespace suffuse::answer {
namespace {

using study::Result;

TEST(Headlines, SayMassPermeabilityStressAndFindings) {
    const erosion::ErosionResult erosion = test::sample_erosion();
    std::vector<study::Finding> findings(7);
    findings[0].met = findings[3].met = true;
    findings[1].met = false;
    const std::vector<Headline> headlines = erosion_headlines(erosion, {}, nullptr);
    ASSERT_EQ(headlines.size(), 3U);
    EXPECT_EQ(headlines[0].value, "15 %"); // (0.0764 + 0.012)/0.6
    EXPECT_EQ(headlines[0].detail, "in two passes at i = 0.05; no replicate");
    EXPECT_EQ(headlines[1].value, "× 3.5"); // 1.9e-10/5.4e-11
    EXPECT_EQ(headlines[1].detail, "0.53 mm/s to 1.9 mm/s; no replicate");
    EXPECT_EQ(headlines[2].value, "−28 %");
    EXPECT_EQ(headlines[2].detail, "after pass 2, the largest loss; no replicate");
    const std::optional<Headline> met = findings_headline(findings);
    EXPECT_EQ(met.value().value, "2 of 7");
    EXPECT_EQ(met.value().detail, "1 not met; 4 cannot tell");
    EXPECT_FALSE(findings_headline({}).has_value());
}

TEST(Headlines, OfSeveralSeedsAreMeansWithTheirDeviation) {
    study::OutcomePoint point;
    point.result[Result::ErodedMass] = study::scatter_of({0.10, 0.14});
    point.result[Result::PermeabilityChange] = study::scatter_of({3.0, 3.0});
    point.result[Result::StressChange] = study::scatter_of({-0.2801, -0.2802});
    const std::vector<Headline> headlines = erosion_headlines(test::sample_erosion(), {}, &point);
    EXPECT_EQ(headlines[0].value, "12 %");
    EXPECT_EQ(headlines[0].spread, "± 3"); // 4/sqrt(2), with the digits of the mean
    EXPECT_EQ(headlines[1].value, "× 3.0");
    EXPECT_EQ(headlines[1].detail, "0.53 mm/s to 1.9 mm/s in the first sample; the same in two samples");
    EXPECT_EQ(headlines[2].detail, "the largest loss of a pass; the same to the digits shown in two samples");
}

TEST(Headlines, APermeabilityThatIsKnownToBeTooHighSaysSoAtTheNumber) {
    erosion::ErosionResult erosion = test::sample_erosion();
    erosion.passes.back().flow_after.raised_by_fines = 1.2;
    EXPECT_EQ(erosion_headlines(erosion, {}, nullptr)[1].lead, "up to");
    EXPECT_FALSE(erosion_headlines(erosion, {}, nullptr)[1].caution.empty());
    erosion.passes.back().flow_after.solver = flow::Solver::Resolved;
    EXPECT_TRUE(erosion_headlines(erosion, {}, nullptr)[1].caution.empty());
}

TEST(Headlines, OfFinesAreTheThresholdsThatMostSeedsHave) {
    using enum study::ThresholdKind;
    const std::vector<study::ContentThreshold> thresholds = {
        {LowestLoose, study::scatter_of({0.40, 0.42})},
        {LowestBetween, study::scatter_of({0.38}), 0.25},
        {LowestDense, study::scatter_of({0.25})},
        {ActiveFines, study::scatter_of({0.331, std::nan(""), std::nan("")})}, // a minority's is noise
        {StrongContacts, study::scatter_of({})}};
    const std::vector<Headline> headlines = fines_headlines(thresholds);
    ASSERT_EQ(headlines.size(), 2U);
    EXPECT_EQ(headlines[0].value, "41 %");
    EXPECT_EQ(headlines[0].spread, "± 1"); // sqrt(2)
    EXPECT_EQ(headlines[1].detail, "fines content, by a parabola; no replicate");
}

TEST(Headlines, OfFinesHalfOfTheSeedsAreNotMostOfThem) {
    const auto cards = [](const std::vector<double>& of_seed) {
        return fines_headlines({{study::ThresholdKind::ActiveFines, study::scatter_of(of_seed)}}).size();
    };
    EXPECT_EQ(cards({0.3, std::nan("")}), 0U);
    EXPECT_EQ(cards({0.3, 0.3, std::nan("")}), 1U);
}

TEST(Headlines, AChangeThatIsNoiseIsNone) {
    erosion::ErosionResult erosion = test::sample_erosion();
    for (erosion::PassResult& pass : erosion.passes) {
        pass.stress_constant_volume = (1 - 1e-9) * pass.stress_before;
    }
    EXPECT_EQ(erosion_headlines(erosion, {}, nullptr)[2].value, "unchanged");
}

TEST(Headlines, AMeanStressThatRisesIsNoLoss) {
    erosion::ErosionResult erosion = test::sample_erosion();
    for (erosion::PassResult& pass : erosion.passes) {
        pass.stress_constant_volume = (1 + 0.03 * pass.pass) * pass.stress_before;
    }
    const Headline stress = erosion_headlines(erosion, {}, nullptr)[2];
    EXPECT_EQ(stress.value, "+3.0 %");
    EXPECT_EQ(stress.detail, "after pass 1, the smallest gain; no replicate");
}

TEST(Headlines, APermeabilityWhoseFirstValueIsTooHighIsALowerBound) {
    erosion::ErosionResult erosion = test::sample_erosion();
    erosion.passes.front().probe.flow.raised_by_fines = 1.2;
    EXPECT_EQ(erosion_headlines(erosion, {}, nullptr)[1].lead, "at least");
}

TEST(Headlines, LeaveOutWhatTheRunCannotDecide) {
    EXPECT_TRUE(erosion_headlines({}, {}, nullptr).empty());
    erosion::ErosionResult erosion;
    erosion.passes.emplace_back().pass = 1;
    const std::vector<Headline> headlines = erosion_headlines(erosion, {}, nullptr);
    ASSERT_EQ(headlines.size(), 1U);
    EXPECT_EQ(headlines[0].value, "none");
    EXPECT_EQ(headlines[0].detail, "in one pass; no replicate");
}

/// A study of one swept key, with a result at each value.
study::StudyOutcome swept(Result which, const std::vector<std::vector<double>>& of_value) {
    study::StudyOutcome outcome;
    outcome.keys = {"stage.erosion.gradient"};
    double value = 0;
    for (const std::vector<double>& of_seed : of_value) {
        study::OutcomePoint point;
        point.at.value = {++value};
        point.at.written = {fmt::format("{}", value)};
        point.samples.resize(of_seed.size(), nullptr);
        point.result[which] = study::scatter_of(of_seed);
        outcome.points.push_back(std::move(point));
    }
    return outcome;
}

TEST(Headlines, OfASweepGoFromTheLeastToTheMostWithTheirDeviations) {
    const auto headlines = sweep_headlines(swept(Result::ErodedMass, {{0.03, 0.05}, {0.1, 0.1}, {0.18, 0.22}}), {});
    ASSERT_EQ(headlines.size(), 1U);
    EXPECT_EQ(headlines[0].value, "4.0 % to 20 %");
    EXPECT_EQ(headlines[0].detail, "at gradient 1 (± 1.4) and 3 (± 3)"); // 2/sqrt(2), 4/sqrt(2)
    EXPECT_EQ(headlines[0].samples, 2);
}

TEST(Headlines, OfASweepMarkThePointsThatAreUpperBounds) {
    study::StudyOutcome outcome = swept(Result::FirstMovement, {{0.2}, {0.4}});
    outcome.points[1].at_most.insert(Result::FirstMovement);
    outcome.first_probe = "level";
    EXPECT_EQ(sweep_headlines(outcome, {}).at(0).value, "0.20 to ≤ 0.40");
    EXPECT_EQ(sweep_headlines(outcome, {}).at(0).detail, "at gradient 1 and 2; no replicate; stage “level”");
    const figures::PageTable table = tabulate_samples(outcome, {}).value();
    EXPECT_EQ(table.rows[0][2], "0.20");
    EXPECT_EQ(table.rows[1][2], "≤ 0.40");
    EXPECT_EQ(
        table.note, "One sample each. ≤: motion had not ended when the gradient rose. First movements are those of the "
                    "stage “level”."
    );
}

TEST(Headlines, OfASweepWhoseEndsDifferNoMoreThanSeedsSayThatItIsTheSame) {
    const auto headlines = sweep_headlines(swept(Result::ErodedMass, {{0.03, 0.06}, {0.05, 0.07}}), {});
    EXPECT_NE(headlines.at(0).detail.find("the same within scatter"), std::string::npos) << headlines.at(0).detail;
}

} // namespace
} // namespace suffuse::answer
