#include "suffuse/study/findings.hpp"

#include "suffuse/study/finding_guide.hpp"
#include "suffuse/study/findings_fines.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::study {
namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using erosion::ProbeResult;

/// A probe whose `free` first grains are detachable and run at `fast`; the `blocked` others move at `slow` [m/s].
ProbeResult probe(double gradient, int free, int blocked, double fast = 1e-5, double slow = 1e-7) {
    ProbeResult result;
    result.gradient = gradient;
    result.watch = 1000;
    for (int g = 0; g < free + blocked; ++g) {
        result.id.push_back(static_cast<std::uint32_t>(g));
        result.by_velocity.push_back(g < free ? 1 : 0);
        std::array<double, erosion::probe_samples + 1> speed{};
        speed.fill(g < free ? fast : slow);
        result.speed.push_back(speed);
    }
    return result;
}

PassResult pass(int number, std::map<int, std::int64_t> coordination = {{0, 10}}) {
    PassResult result;
    result.pass = number;
    for (const auto& [contacts, count] : coordination) {
        result.removed += count;
    }
    result.coordination_histogram = std::move(coordination);
    result.stress_before = diagonal({1e5, 1e5, 1e5});
    result.stress_constant_volume = result.stress_before;
    return result;
}

ErosionResult passes(std::vector<PassResult> all) {
    ErosionResult result;
    result.passes = std::move(all);
    return result;
}

Finding finding(const std::string& id, const std::vector<ProbeResult>& probes, const ErosionResult& erosion) {
    for (Finding& each : judge_erosion(probes, erosion)) {
        if (each.id == id) {
            return each;
        }
    }
    ADD_FAILURE() << id << " is not judged";
    return {};
}

std::optional<bool> met(const std::string& id, const std::vector<ProbeResult>& probes, const ErosionResult& erosion) {
    return finding(id, probes, erosion).met;
}

TEST(Findings, AllSevenAreJudgedInOrderAndAnEmptyRunDecidesNone) {
    const std::vector<Finding> findings = judge_erosion({}, {});
    ASSERT_EQ(findings.size(), 7U);
    for (std::size_t f = 0; f < findings.size(); ++f) {
        EXPECT_EQ(findings[f].id, fmt::format("E{}", f + 1));
        EXPECT_FALSE(findings[f].met.has_value()) << findings[f].id;
        EXPECT_FALSE(findings[f].ours.empty()) << findings[f].id;
        EXPECT_FALSE(findings[f].claim.empty());
        EXPECT_FALSE(findings[f].paper.empty());
    }
}

TEST(Findings, E1NeedsNoneWithoutFlowAndSomeAtOneHundredth) {
    EXPECT_EQ(met("E1", {probe(0, 0, 5), probe(0.01, 2, 3)}, {}), true);
    EXPECT_EQ(met("E1", {probe(0, 0, 5), probe(0.01, 0, 5)}, {}), false);
    EXPECT_EQ(met("E1", {probe(0, 1, 4), probe(0.01, 2, 3)}, {}), false);
    EXPECT_EQ(met("E1", {probe(0, 0, 5)}, {}), std::nullopt);
    EXPECT_EQ(met("E1", {probe(0.01, 2, 3), probe(0.05, 2, 3)}, {}), std::nullopt);
    // One half already fails, so the other half need not be known.
    EXPECT_EQ(met("E1", {probe(0, 1, 4)}, {}), false);
    EXPECT_NE(
        finding("E1", {probe(0, 0, 5), probe(0.01, 2, 3)}, {}).ours.find("2 of 5 at i = 0.01"), std::string::npos
    );
}

TEST(Findings, E2ComparesTheMediansOfTheTwoGroups) {
    EXPECT_EQ(met("E2", {probe(0.05, 3, 4, 1e-6, 0.99e-7)}, {}), true);
    EXPECT_EQ(met("E2", {probe(0.05, 3, 4, 1e-6, 1.01e-7)}, {}), false);
    EXPECT_EQ(met("E2", {probe(0.05, 3, 4, 1e-6, 0)}, {}), true);
    EXPECT_EQ(met("E2", {probe(0.05, 0, 4)}, {}), std::nullopt);
    EXPECT_EQ(met("E2", {probe(0.05, 4, 0)}, {}), std::nullopt);
    EXPECT_EQ(met("E2", {probe(0.1, 3, 4)}, {}), std::nullopt);
}

TEST(Findings, E2ReadsTheSpeedAtOneThousandIterationsWhateverTheWatch) {
    ProbeResult longer = probe(0.05, 3, 4, 1e-6, 1e-6);
    longer.watch = 2000;
    for (std::size_t g = 0; g < 3; ++g) {
        longer.speed[g].back() = 1; // ten times apart only after 2000 iterations
    }
    EXPECT_EQ(met("E2", {longer}, {}), false);
    for (std::size_t g = 0; g < 3; ++g) {
        longer.speed[g][5] = 1e-4; // sample 5 of 10 is iteration 1000
    }
    EXPECT_EQ(met("E2", {longer}, {}), true);

    ProbeResult shorter = probe(0.05, 3, 4, 1e-6, 1e-6);
    shorter.watch = 500;
    EXPECT_EQ(met("E2", {shorter}, {}), std::nullopt);
    ProbeResult coarse = probe(0.05, 3, 4, 1e-6, 1e-6);
    coarse.watch = 20'000;
    EXPECT_EQ(met("E2", {coarse}, {}), std::nullopt);
}

TEST(Findings, E2TakesTheProbeOfTheFirstPassWhereThereIsNoOther) {
    ErosionResult erosion = passes({pass(1)});
    erosion.passes[0].probe = probe(0.05, 3, 4);
    EXPECT_EQ(met("E2", {}, erosion), true);
}

TEST(Findings, E3AllowsFewerThanATenthWithMoreThanTwoContacts) {
    EXPECT_EQ(met("E3", {}, passes({pass(1, {{0, 80}, {2, 11}, {3, 9}})})), true);
    EXPECT_EQ(met("E3", {}, passes({pass(1, {{0, 80}, {2, 10}, {3, 9}, {7, 1}})})), false);
    EXPECT_EQ(met("E3", {}, passes({pass(1, {})})), std::nullopt);
    EXPECT_EQ(met("E3", {}, passes({pass(2, {{0, 80}})})), std::nullopt);
}

TEST(Findings, E4WantsMoreThanHalfWithAtLeastTwoContacts) {
    EXPECT_EQ(met("E4", {}, passes({pass(1), pass(2, {{1, 49}, {2, 51}})})), true);
    EXPECT_EQ(met("E4", {}, passes({pass(1), pass(2, {{1, 50}, {2, 50}})})), false);
    EXPECT_EQ(met("E4", {}, passes({pass(1), pass(2, {})})), std::nullopt);
    EXPECT_EQ(met("E4", {}, passes({pass(1)})), std::nullopt);
}

TEST(Findings, E5WantsNoStrainFirstAndContractionThen) {
    const auto strains = [](double first, double second) {
        ErosionResult erosion = passes({pass(1), pass(2)});
        erosion.passes[0].volumetric_strain = first;
        erosion.passes[1].volumetric_strain = second;
        return met("E5", {}, erosion);
    };
    EXPECT_EQ(strains(0.9e-4, 1.1e-3), true);
    EXPECT_EQ(strains(1.1e-4, 1.1e-3), false);
    EXPECT_EQ(strains(-1.1e-4, 1.1e-3), false);
    EXPECT_EQ(strains(0, 0.9e-3), false);
    EXPECT_EQ(strains(0, -2e-3), false); // dilation is no collapse
    EXPECT_EQ(met("E5", {}, passes({pass(1)})), std::nullopt);
    ErosionResult first_fails = passes({pass(1)});
    first_fails.passes[0].volumetric_strain = 1e-3;
    EXPECT_EQ(met("E5", {}, first_fails), false);
}

TEST(Findings, APassThatTookNothingDoesNotShowWhatRemovalDoes) {
    const ErosionResult erosion = passes({pass(1), pass(2, {})});
    for (const char* id : {"E4", "E5", "E7"}) {
        EXPECT_EQ(met(id, {}, erosion), std::nullopt) << id;
    }
    EXPECT_EQ(finding("E5", {}, erosion).ours, "below 0.01 % in pass 1; pass 2 took no grain");
    EXPECT_EQ(finding("E7", {}, erosion).ours, "pass 1: 100 to 100 kPa (unchanged); pass 2 took no grain");
}

TEST(Findings, E6WantsARiseOnEachRemovalAndAFallInTheSecondPass) {
    const auto porosities = [](double after_removal, double resettled) {
        ErosionResult erosion = passes({pass(1), pass(2)});
        for (PassResult& each : erosion.passes) {
            each.porosity_before = 0.40;
            each.porosity_after_removal = after_removal;
            each.porosity_after = resettled;
        }
        return met("E6", {}, erosion);
    };
    EXPECT_EQ(porosities(0.45, 0.44), true);
    EXPECT_EQ(porosities(0.45, 0.45), false);
    EXPECT_EQ(porosities(0.45, 0.45 - 4e-9), false); // within the servo's tolerance: no fall
    EXPECT_EQ(porosities(0.45, 0.46), false);
    EXPECT_EQ(porosities(0.39, 0.38), false);
    EXPECT_EQ(met("E6", {}, passes({pass(1, {}), pass(2, {})})), std::nullopt);
    ErosionResult one = passes({pass(1)});
    one.passes[0].porosity_after_removal = 0.1;
    EXPECT_EQ(met("E6", {}, one), std::nullopt);
}

TEST(Findings, E6ReportsTheFirstPassesAndCountsTheOthers) {
    ErosionResult erosion = passes({pass(1), pass(2), pass(3), pass(4), pass(5), pass(6)});
    erosion.passes[5].porosity_after_removal = erosion.passes[5].porosity_before + 0.01;
    const std::string ours = finding("E6", {}, erosion).ours;
    EXPECT_NE(ours.find("pass 4:"), std::string::npos) << ours;
    EXPECT_EQ(ours.find("pass 5:"), std::string::npos) << ours;
    EXPECT_NE(ours.find("it rises in 1 of 2 more passes"), std::string::npos) << ours;
}

TEST(Findings, E7WantsTheStressKeptFirstAndLostThen) {
    const auto stresses = [](double first, double second) {
        ErosionResult erosion = passes({pass(1), pass(2)});
        erosion.passes[0].stress_constant_volume = diagonal({first, first, first});
        erosion.passes[1].stress_constant_volume = diagonal({second, second, second});
        return met("E7", {}, erosion);
    };
    EXPECT_EQ(stresses(0.991e5, 0.89e5), true);
    EXPECT_EQ(stresses(0.989e5, 0.89e5), false);
    EXPECT_EQ(stresses(0.991e5, 0.91e5), false);
    EXPECT_EQ(met("E7", {}, passes({pass(1)})), std::nullopt);
    ErosionResult unstressed = passes({pass(1), pass(2)});
    unstressed.passes[0].stress_before = unstressed.passes[1].stress_before = {};
    EXPECT_EQ(met("E7", {}, unstressed), std::nullopt);
}

TEST(Findings, SeedsThatDisagreeAreUndecided) {
    const ErosionResult erodes = passes({pass(1), pass(2, {{2, 10}})}), stays = passes({pass(1), pass(2, {{0, 10}})});
    const auto e4 = [](const std::vector<std::vector<Finding>>& seeds) { return combine_seeds(seeds)[3].met; };
    EXPECT_EQ(e4({judge_erosion({}, erodes), judge_erosion({}, erodes)}), true);
    EXPECT_EQ(e4({judge_erosion({}, stays), judge_erosion({}, stays)}), false);
    EXPECT_EQ(e4({judge_erosion({}, erodes), judge_erosion({}, stays)}), std::nullopt);
    EXPECT_TRUE(combine_seeds({}).empty());
}

/// A pass whose rule took `refused` grains that do what their twin does, and `accepted` that the water moves.
PassResult taken_by_threshold(int number, std::int64_t refused, std::int64_t accepted, double signal) {
    PassResult result = pass(number, {{0, accepted}, {3, refused}});
    result.detachable = refused + accepted;
    result.probe.agreement[1] = {refused, accepted};
    result.probe.signal_over_twin = signal;
    result.probe.unbalanced_force = 3e-5;
    return result;
}

TEST(Findings, WhatTheTwinDoesNotDistinguishIsMetByNoise) {
    const PassResult clean = taken_by_threshold(1, 15, 2870, 19);
    const Finding noisy = finding("E4", {}, passes({clean, taken_by_threshold(2, 283, 18, 1.01)}));
    EXPECT_EQ(noisy.met, true);
    EXPECT_EQ(standing_of(noisy), Standing::MetByNoise);
    EXPECT_EQ(
        noisy.why, "Of 301 grains that pass 2 found detachable, 18 moved beyond their twin without water. The fines "
                   "moved 1.01 times as fast as the twin's in the median, at an unbalance of 3·10⁻⁵: the residual "
                   "unbalanced forces move them, not the water."
    );
    EXPECT_EQ(standing_of(finding("E3", {}, passes({clean}))), Standing::Met) << "a bounce here and there is no noise";

    const Finding elastic = finding("E4", {}, passes({clean, taken_by_threshold(2, 283, 18, 800)}));
    EXPECT_NE(elastic.why.find("deform elastically"), std::string::npos);
    PassResult otherwise = taken_by_threshold(2, 283, 18, 1.01);
    otherwise.detachable = 18; // the rule on displacement took them
    EXPECT_EQ(standing_of(finding("E4", {}, passes({clean, otherwise}))), Standing::Met);
}

TEST(Findings, AContractionBetweenOurBoundsFailsByOurNumberAlone) {
    const auto with_strains = [](double first, double second) {
        ErosionResult erosion = passes({pass(1), pass(2, {{3, 10}})});
        erosion.passes[0].volumetric_strain = first, erosion.passes[1].volumetric_strain = second;
        return standing_of(finding("E5", {}, erosion));
    };
    EXPECT_EQ(with_strains(1e-5, 2e-3), Standing::Met);
    EXPECT_EQ(with_strains(1e-5, 2e-4), Standing::NotMetByOurNumber) << "no longer negligible";
    EXPECT_EQ(with_strains(2e-4, 2e-2), Standing::NotMetByOurNumber) << "not yet important";
    EXPECT_EQ(with_strains(1e-5, 5e-5), Standing::NotMet) << "both negligible";
    EXPECT_EQ(with_strains(2e-4, 3e-4), Standing::NotMet) << "neither";
    EXPECT_EQ(with_strains(2e-3, 2e-3), Standing::NotMet) << "both important";
}

TEST(Findings, AStressLossBetweenOurBoundsFailsByOurNumberAlone) {
    const auto with_losses = [](double first, double second) {
        ErosionResult erosion = passes({pass(1), pass(2, {{3, 10}})});
        erosion.passes[0].stress_constant_volume = (1 - first) * erosion.passes[0].stress_before;
        erosion.passes[1].stress_constant_volume = (1 - second) * erosion.passes[1].stress_before;
        return finding("E7", {}, erosion);
    };
    EXPECT_EQ(standing_of(with_losses(0.006, 0.2)), Standing::Met);
    EXPECT_EQ(standing_of(with_losses(0.006, 0.075)), Standing::NotMetByOurNumber);
    EXPECT_NE(with_losses(0.006, 0.075).why.find("less than 1 %, more than 10 %"), std::string::npos);
    EXPECT_EQ(standing_of(with_losses(0.059, 1)), Standing::NotMetByOurNumber);
    EXPECT_EQ(standing_of(with_losses(0.047, 0.0497)), Standing::NotMet);
}

TEST(Findings, TheReasonWhyASecondPassFindsNoLoadedGrainNamesTheSeepageForce) {
    ErosionResult erosion = passes({pass(1), pass(2, {{0, 4}})});
    erosion.passes[1].probe.fluid_over_contact = 5.2e-7;
    for (PassResult& each : erosion.passes) {
        each.porosity_before = 0.4, each.porosity_after_removal = each.porosity_after = 0.48;
    }
    const Finding active = finding("E4", {}, erosion);
    EXPECT_EQ(
        active.why, "No grain that left in pass 2 carried load: pass 1 took what carries nothing, and only what it set "
                    "free was left over. The seepage force on a fine grain is 5.2·10⁻⁷ of the mean contact force, so "
                    "loaded fines stay."
    );
    for (const char* id : {"E5", "E6", "E7"}) {
        EXPECT_EQ(finding(id, {}, erosion).why, active.why) << id;
    }
    EXPECT_FALSE(finding("E4", {}, passes({pass(1)})).why.empty());
    EXPECT_FALSE(finding("E1", {}, {}).why.empty()) << "what would tell";
}

TEST(Findings, OurNumbersStandInTheCriterionAndEveryFindingHasItsShortExplanation) {
    std::vector<Finding> all = judge_erosion({}, {});
    const StageCurve nothing;
    for (const Finding& each : judge_fines(&nothing, &nothing, {})) {
        all.push_back(each);
    }
    ASSERT_EQ(all.size(), 16U);
    for (const Finding& each : all) {
        std::size_t from = 0;
        for (const std::string& number : each.our_numbers) {
            from = each.claim.find(number, from);
            ASSERT_NE(from, std::string::npos) << each.id << ": " << number;
        }
        EXPECT_FALSE(background_of(each.id).empty()) << each.id;
    }
    EXPECT_TRUE(background_of("E8").empty());
}

TEST(Findings, SeedsThatDisagreeAreDistinguishedFromAnUndecidedRun) {
    const auto of = [](Verdict met, Verdict in_words, const char* why) {
        return std::vector<Finding>{
            {.id = "E5", .claim = "", .paper = "", .ours = "", .met = met, .in_words = in_words, .why = why}};
    };
    const Finding mixed = combine_seeds({of(true, true, ""), of(false, false, "No grain left.")}).front();
    EXPECT_EQ(mixed.met, std::nullopt);
    EXPECT_EQ(standing_of(mixed), Standing::SeedsDisagree);
    EXPECT_EQ(mixed.why, "The seeds disagree: 1 of 2 meet it. Where it is not: No grain left.");

    const Finding in_words = combine_seeds({of(true, true, ""), of(false, true, "Too few.")}).front();
    EXPECT_EQ(standing_of(in_words), Standing::NotMetByOurNumber);
    EXPECT_EQ(
        standing_of(combine_seeds({of(false, true, ""), of(false, true, "")}).front()), Standing::NotMetByOurNumber
    );
    const Finding not_met = combine_seeds({of(false, true, "By a number."), of(false, false, "No grain.")}).front();
    EXPECT_EQ(standing_of(not_met), Standing::NotMet);
    EXPECT_EQ(not_met.why, "No grain.");
    EXPECT_EQ(standing_of(combine_seeds({of(true, true, ""), of({}, {}, "")}).front()), Standing::Undecided);
}

TEST(Findings, OfOneReasonAreReportedByTheFirst) {
    std::vector<Finding> findings(3);
    findings[0].id = "E4", findings[0].why = findings[1].why = "Noise.";
    EXPECT_EQ(reason_in_table(findings, 0), "Noise.");
    EXPECT_EQ(reason_in_table(findings, 1), "As E4.");
    EXPECT_EQ(reason_in_table(findings, 2), "");
}

TEST(Findings, AreCountedByTheirStanding) {
    std::vector<Finding> findings(5);
    findings[0].met = findings[1].met = true, findings[1].is_noise = true;
    findings[2].met = false, findings[2].in_words = true;
    findings[3].met = false;
    EXPECT_EQ(agreement_of(findings[0]), true);
    EXPECT_EQ(agreement_of(findings[1]), std::nullopt);
    EXPECT_EQ(agreement_of(findings[3]), false);
    EXPECT_EQ(
        count_standings(findings), "1 of 5 met; 1 met by noise; 1 not met by our number; 1 not met; 1 cannot tell"
    );
}

} // namespace
} // namespace suffuse::study
