#include "suffuse/study/findings.hpp"

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

TEST(Findings, AllSevenAreJudgedInOrderAndAnEmptyRunCannotTellAny) {
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

TEST(Findings, APassThatTookNothingCannotTellWhatRemovalDoes) {
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

TEST(Findings, E6IsToldOfTheFirstPassesAndCountsTheOthers) {
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

TEST(Findings, SeedsThatDisagreeCannotTell) {
    const ErosionResult erodes = passes({pass(1), pass(2, {{2, 10}})}), stays = passes({pass(1), pass(2, {{0, 10}})});
    const auto e4 = [](const std::vector<std::vector<Finding>>& seeds) { return combine_seeds(seeds)[3].met; };
    EXPECT_EQ(e4({judge_erosion({}, erodes), judge_erosion({}, erodes)}), true);
    EXPECT_EQ(e4({judge_erosion({}, stays), judge_erosion({}, stays)}), false);
    EXPECT_EQ(e4({judge_erosion({}, erodes), judge_erosion({}, stays)}), std::nullopt);
    EXPECT_TRUE(combine_seeds({}).empty());
}

} // namespace
} // namespace suffuse::study
