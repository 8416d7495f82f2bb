#include "suffuse/answer/verdict.hpp"

#include "suffuse/answer/opening.hpp"
#include "suffuse/answer/samples_table.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <sstream>

namespace suffuse::answer {
namespace {

using study::Result;

/// Words as a reader counts them: what has a letter or a digit in it.
std::size_t count_words(const std::string& sentence) {
    std::istringstream rest(sentence);
    std::size_t count = 0;
    for (std::string word; rest >> word;) {
        count += std::ranges::any_of(word, [](unsigned char c) { return std::isalnum(c) != 0; }) ? 1U : 0U;
    }
    return count;
}

/// One to three sentences of at most 20 words, each a line.
void expect_short(const std::vector<std::string>& verdict) {
    EXPECT_GE(verdict.size(), 1U);
    EXPECT_LE(verdict.size(), 3U);
    for (const std::string& line : verdict) {
        EXPECT_LE(count_words(line), 20U) << line;
        EXPECT_TRUE(line.ends_with('.')) << line;
    }
}

class Verdict : public testing::Test {
protected:
    Verdict() {
        study.name = "dam";
        results.what = &what;
    }

    /// A point of the study for each list of seeds, over the values of one key.
    void sweep(Result which, const std::vector<std::pair<std::string, std::vector<double>>>& points) {
        study::StudyOutcome outcome{.study = &study, .keys = {"stage.erosion.gradient"}};
        for (const auto& [written, of_seed] : points) {
            study::OutcomePoint point;
            char* end = nullptr;
            const double value = std::strtod(written.c_str(), &end);
            point.at.value = {end == written.c_str() ? std::nan("") : value};
            point.at.written = {written};
            for (std::size_t k = 0; k < of_seed.size(); ++k) {
                variants.push_back({.folder = "dam/" + written + "/rep=" + std::to_string(k + 1)});
                point.samples.push_back(&variants.back());
            }
            point.result[which] = study::scatter_of(of_seed);
            outcome.points.push_back(std::move(point));
        }
        results.outcomes = {std::move(outcome)};
    }

    [[nodiscard]] std::vector<std::string> verdict() const {
        std::vector<std::string> lines = verdict_of_run(results);
        expect_short(lines);
        return lines;
    }

    casefile::Case what;
    casefile::Study study;
    std::deque<casefile::Variant> variants; ///< stay where they are
    study::RunResults results;
};

TEST_F(Verdict, OfAnErosionSaysWhatLeftAndWhatThatDid) {
    results.story.erosion = test::sample_erosion();
    results.story.erosion.passes.front().probe.gradient = 0.05;
    EXPECT_EQ(
        verdict(), (std::vector<std::string>{
                       "Water at i = 0.05 carries out 15 % of the mass, in two passes.",
                       "The permeability rises to 3.5 times its initial value."})
    );
    results.story.erosion.passes.back().flow_after.raised_by_fines = 1.5;
    EXPECT_EQ(verdict().at(1), "The permeability rises to at most 3.5 times its initial value.")
        << "known to be too high";
    results.story.erosion.passes.front().probe.flow.raised_by_fines = 1.5;
    EXPECT_EQ(verdict().at(1), "The permeability rises to about 3.5 times its initial value.");
    results.story.erosion.passes.back().flow_after.raised_by_fines.reset();
    EXPECT_EQ(verdict().at(1), "The permeability rises to at least 3.5 times its initial value.");
    for (erosion::PassResult& pass : results.story.erosion.passes) {
        pass.eroded_mass_percent_of_initial = 0;
    }
    EXPECT_EQ(verdict().front(), "Water at i = 0.05 carries out none of the fines.");
}

TEST_F(Verdict, APermeabilityStaysWithinHalfAPercent) {
    results.story.erosion = test::sample_erosion();
    const auto reported = [&](double change) {
        sweep(Result::PermeabilityChange, {{"0.05", {change}}});
        return verdict().at(1);
    };
    EXPECT_EQ(reported(1.0049), "The permeability does not change.");
    EXPECT_EQ(reported(0.9951), "The permeability does not change.");
    EXPECT_EQ(reported(0.9949), "The permeability falls to 99 % of its initial value.");
    EXPECT_EQ(reported(1.0051), "The permeability rises by 0.5 %.");
    EXPECT_EQ(reported(1.0949), "The permeability rises by 9.5 %.");
    EXPECT_EQ(reported(1.11), "The permeability rises to 1.1 times its initial value.");
}

TEST_F(Verdict, OfARemovalKeepsTheVolumeThatChangesByLessThanHalfAPerMille) {
    const auto reported = [&](double strain) {
        sweep(Result::RemovedMass, {{"0.05", {0.12}}});
        results.outcomes.front().points.front().result[Result::RemovalStrain] = study::scatter_of({strain});
        return verdict().at(1);
    };
    EXPECT_EQ(reported(0.00049), "The soil keeps its volume.");
    EXPECT_EQ(reported(-0.00049), "The soil keeps its volume.");
    EXPECT_EQ(reported(0.00051), "The soil contracts by 0.1 %.");
    EXPECT_EQ(reported(-0.00051), "The soil dilates by 0.1 %.");
}

TEST_F(Verdict, OfMoreThanThreeComparedTestsIsHowManyFindTheSoilWeaker) {
    results.story.erosion = test::sample_erosion();
    const casefile::Stage test{.name = "shear", .spec = triaxial::TriaxialSpec{}};
    study::StrengthChange change;
    change.before = change.after = &test;
    change.peak_deviator = {study::scatter_of({400e3}), study::scatter_of({300e3}), study::scatter_of({-0.25})};
    results.strength.assign(3, change);
    EXPECT_EQ(verdict().back(), "The peak strength falls by 25 %, from 400 to 300 kPa.");
    results.strength.assign(4, change);
    results.strength.back().peak_deviator.change = study::scatter_of({0.25});
    EXPECT_EQ(verdict().back(), "3 of 4 tests after the loss find the soil weaker.");
}

TEST_F(Verdict, OfFinesReportsTheThresholdsThatMoreThanHalfOfTheSeedsHave) {
    using enum study::ThresholdKind;
    results.fines.emplace().thresholds = {
        {LowestLoose, study::scatter_of({0.40, 0.42})}, {ActiveFines, study::scatter_of({0.3, std::nan("")})}};
    EXPECT_EQ(verdict(), std::vector<std::string>{"The void ratio is lowest at 41 % fines."});
    results.fines->thresholds.back().at = study::scatter_of({0.3, 0.3, std::nan("")});
    EXPECT_EQ(verdict().back(), "From 30 % on the fines begin to carry load.");
}

TEST_F(Verdict, OfARunWithoutErosionIsItsStrengthPermeabilityAndVoidRatio) {
    sweep(Result::Strength, {{"0.05", {338e3}}});
    results.outcomes.front().points.front().result[Result::Permeability] = study::scatter_of({5.6e-11});
    results.outcomes.front().points.front().result[Result::VoidRatio] = study::scatter_of({0.5294});
    EXPECT_EQ(
        verdict(), (std::vector<std::string>{
                       "The soil bears a deviator stress of 338 kPa.",
                       "Under a gradient of one, water seeps at 0.55 mm/s.", "The grains rest at void ratio 0.529."})
    );
    const Opening opening = open_answer(results, {});
    EXPECT_EQ(opening.confidence, "One sample");
    EXPECT_NE(opening.about_confidence.find("`--set study.dam.replicates=3`"), std::string::npos);
    for (const Headline& card : opening.cards) {
        EXPECT_NE(card.detail.find("no replicate"), std::string::npos) << card.label;
    }
}

TEST_F(Verdict, OfASweepSaysHowItsResultDependsOnTheKey) {
    sweep(Result::ErodedMass, {{"0.05", {0.02, 0.04}}, {"0.1", {0.08, 0.09}}, {"0.2", {0.18, 0.22}}});
    EXPECT_EQ(verdict().front(), "From gradient 0.05 to 0.2 the mass carried out rises from 3.0 % to 20 %.");
    const Opening opening = open_answer(results, {});
    EXPECT_EQ(opening.confidence, "Two seeds each");
    EXPECT_EQ(opening.pictures.front(), "own-sweep");
}

TEST_F(Verdict, OfASweepWithinTheScatterOfItsSamplesIsThatItMakesNoMeasurableDifference) {
    sweep(Result::ErodedMass, {{"0.05", {0.10, 0.14}}, {"0.1", {0.11, 0.15}}});
    EXPECT_EQ(verdict().front(), "The gradient makes no measurable difference to the mass carried out: 12 % to 13 %.");
}

TEST_F(Verdict, OfASweepOverWordsNamesTheLowestAndTheHighest) {
    sweep(Result::ErodedMass, {{"random", {0.02}}, {"smallest", {0.2}}, {"largest", {0.1}}});
    EXPECT_EQ(
        verdict().front(), "The mass carried out is least at gradient random (2.0 %) and most at smallest (20 %)."
    );
}

TEST_F(Verdict, OfASweepCountsThePointsThatHaveTheResult) {
    sweep(Result::ErodedMass, {{"0.05", {0.10, 0.14}}, {"0.1", {0.11, 0.15}}, {"0.2", {0, 0}}});
    results.outcomes.front().points.back().result.clear();
    results.outcomes.front().specified = 4;
    EXPECT_EQ(
        verdict().front(),
        "The gradient makes no measurable difference to the mass carried out: 12 % to 13 % (2 of 4 points)."
    );
    EXPECT_EQ(open_answer(results, {}).cards.front().detail, "the same within scatter at 2 of 4 points");
}

TEST_F(Verdict, OfOnePointOfASweepSaysWhichItIs) {
    sweep(Result::Strength, {{"0.05", {338e3}}});
    results.outcomes.front().specified = 4;
    EXPECT_EQ(verdict().front(), "One of 4 points of the sweep has a result: gradient 0.05.");
    EXPECT_EQ(verdict().at(1), "The soil bears a deviator stress of 338 kPa.");
}

TEST_F(Verdict, OfASweepOfSingleSamplesSpeaksOfNoScatter) {
    sweep(Result::ErodedMass, {{"0.05", {0.120}}, {"0.1", {0.124}}});
    EXPECT_EQ(verdict().front(), "The gradient changes the mass carried out little: 12 % to 12 %, one sample each.");
    EXPECT_EQ(open_answer(results, {}).cards.front().detail, "nearly the same at all 2 points; no replicate");
}

TEST_F(Verdict, OfASweepWhoseSmallDifferenceIsBeyondTheScatterDoesNotCallItScatter) {
    sweep(Result::ErodedMass, {{"0.05", {0.1200, 0.1201}}, {"0.1", {0.124, 0.1241}}});
    EXPECT_EQ(verdict().front(), "The gradient changes the mass carried out little: 12 % to 12 %.");
}

TEST_F(Verdict, OfASweepOverTwoKeysNamesBothValuesOfAPoint) {
    sweep(Result::ErodedMass, {{"0.05", {0.02}}, {"0.05", {0.2}}, {"0.1", {0.1}}});
    study::StudyOutcome& outcome = results.outcomes.front();
    outcome.keys.emplace_back("friction");
    int degrees = 10;
    for (study::OutcomePoint& point : outcome.points) {
        point.at.written.push_back(std::to_string(degrees += 10) + " deg");
        point.at.value.push_back(degrees);
    }
    EXPECT_EQ(
        verdict().front(), "The mass carried out is least at gradient 0.05, friction 20° (2.0 %) and most at gradient "
                           "0.05, friction 30° (20 %)."
    );
    EXPECT_EQ(
        open_answer(results, {}).cards.front().detail,
        "at gradient 0.05, friction 20° and gradient 0.05, friction 30°; no replicate"
    );
}

TEST_F(Verdict, OfAnErosionAtSeveralGradientsNamesTheirRange) {
    results.story.erosion = test::sample_erosion();
    results.story.erosion.passes.front().probe.gradient = 0.1;
    results.story.erosion.passes.back().probe.gradient = 1;
    EXPECT_EQ(verdict().front(), "Water at i = 0.1 to 1 carries out 15 % of the mass, in two passes.");
    EXPECT_EQ(open_answer(results, {}).cards.front().detail, "in two passes at i = 0.1 to 1; no replicate");
}

TEST_F(Verdict, OfFinesTakenOutByForceDoesNotNameWater) {
    results.story.erosion = test::sample_erosion();
    for (erosion::LedgerRow& row : results.story.erosion.ledger) {
        row.reason = row.pass == 1 ? erosion::Reason::Velocity : erosion::Reason::Forced;
    }
    EXPECT_EQ(verdict().front(), "Water at i = 0.05 and removal by force take out 15 % of the mass, in two passes.");
    EXPECT_EQ(open_answer(results, {}).cards.front().label, "Mass that left");
    for (erosion::LedgerRow& row : results.story.erosion.ledger) {
        row.reason = erosion::Reason::Forced;
    }
    EXPECT_EQ(verdict().front(), "Fines taken out by force are 15 % of the mass, in two passes.");
    EXPECT_EQ(open_answer(results, {}).cards.front().label, "Mass taken out");
}

TEST_F(Verdict, OfAProbeNamesTheOneOfSeveralSamples) {
    sweep(Result::VoidRatio, {{"0.05", {0.5, 0.6}}});
    results.story.probes = {test::sample_probe(0.1, 10, 1, 3)};
    EXPECT_EQ(verdict().front(), "Water at i = 0.1 detaches 10 of 10 fines in the first of two samples.");
    EXPECT_NE(open_answer(results, {}).about_confidence.find("Numbers are means"), std::string::npos);
    results.outcomes.front().points.front().result.clear();
    EXPECT_NE(open_answer(results, {}).about_confidence.find("Each number is of one sample."), std::string::npos);
}

TEST_F(Verdict, DoubtsAGradientThatLiftsTheSoilAsAWhole) {
    casefile::Variant variant;
    variant.material.density = 2650;
    what.fluid.density = 1000;
    casefile::Stage stage{.name = "erosion", .spec = erosion::ErodeSpec{}};
    results.stages = {{&study, &variant, &stage, {{"grains", 10}}, {}}};
    erosion::PassResult pass;
    pass.pass = 1, pass.porosity_before = 0.4, pass.probe.gradient = 0.98; // i_c = 1.65 * 0.6 = 0.99
    const auto doubts = [&] {
        results.stages.front().findings.erosion = erosion::ErosionResult{.passes = {pass}};
        return open_answer(results, {}).doubts;
    };
    EXPECT_TRUE(doubts().empty());
    pass.probe.gradient = 1;
    ASSERT_EQ(doubts().size(), 1U);
    EXPECT_NE(
        doubts().front().find("With weight, upward flow at i = 1 would lift the soil as a whole"), std::string::npos
    );
    pass.mobility.emplace();
    EXPECT_TRUE(doubts().empty()) << "this flow does not rise";
    pass.mobility->heave_gradient = 0.95;
    EXPECT_NE(
        doubts().front().find("i = 1 is above the gradient that lifts the soil as a whole, 0.95"), std::string::npos
    );
}

TEST_F(Verdict, DoubtsASpecifiedGradientThatLiftsTheSoilAsAWhole) {
    const casefile::Variant variant;
    const casefile::Stage stage{.name = "up", .spec = erosion::DetachStageSpec{}};
    results.stages = {{&study, &variant, &stage, {{"grains", 10}}, {}}};
    erosion::MobilityResult& mobility = results.stages.front().findings.mobility.emplace();
    mobility.heave_gradient = 1.14;
    EXPECT_TRUE(open_answer(results, {}).doubts.empty()) << "no gradient is specified";
    mobility.specified_gradient = 1.4;
    ASSERT_EQ(open_answer(results, {}).doubts.size(), 1U);
    EXPECT_NE(
        open_answer(results, {})
            .doubts.front()
            .find("i = 1.4 is above the gradient that lifts the soil as a whole, 1.14"),
        std::string::npos
    );
}

TEST_F(Verdict, OfNothingYetSaysSo) {
    EXPECT_EQ(verdict(), std::vector<std::string>{"No stage is finished yet."});
    EXPECT_EQ(open_answer(results, {}).confidence, "No result yet");
}

TEST_F(Verdict, HasAtMostSixCardsAndTheFindingsAmongThem) {
    sweep(Result::ErodedMass, {{"0.05", {0.02}}, {"0.1", {0.2}}});
    for (study::OutcomePoint& point : results.outcomes.front().points) {
        for (int k = 0; k < study::results; ++k) {
            point.result.emplace(static_cast<Result>(k), study::scatter_of({0.5}));
        }
    }
    const Opening opening = open_answer(results, std::vector<study::Finding>(7));
    ASSERT_EQ(opening.cards.size(), 6U);
    EXPECT_EQ(opening.cards.back().label, "Findings of the paper met");
    EXPECT_EQ(opening.cards.front().label, "Mass carried out") << "the first answers the question";
}

TEST_F(Verdict, ItsTableOfSamplesSaysWhichToLookAt) {
    sweep(Result::ErodedMass, {{"0.05", {0.02, 0.04}}, {"0.1", {0.08, 0.14}}, {"0.2", {0.30, 0.31}}});
    const figures::PageTable table = tabulate_samples(results.outcomes.front(), what.fluid).value();
    EXPECT_EQ(table.header, (std::vector<std::string>{"gradient", "seeds", "Mass carried out", "which to look at"}));
    EXPECT_EQ(
        table.rows[1], (std::vector<std::string>{
                           "0.1", "2", "11 % ± 4",
                           "its samples differ most: see studies/dam/0.1/rep=1; largest step, to the next value"})
    );
    EXPECT_EQ(table.rows[0].back(), "");
}

} // namespace
} // namespace suffuse::answer
