// What a stage writes about itself in its files, where it is put together from several trials, passes or directions.

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <fstream>
#include <sstream>

namespace suffuse::test {
namespace {

const std::string coarse_sand = R"(
[soil.mixture]
psd               = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] }
grading_tolerance = "10 %"
[study.s]
soil      = "mixture"
particles = 300
[[study.s.stage]]
name = "cloud"
do   = "pack"
)";

/// The rows of a table that a stage left, as text.
std::vector<std::string> lines_of(const std::filesystem::path& table) {
    std::ifstream file(table);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) {
        lines.push_back(line);
    }
    return lines;
}

TEST(StageNumbers, TheHistoryOfACompactionToAVoidRatioIsThatOfTheTrialThatCounts) {
    const TempFolder folder;
    run_text(
        reference_constants + coarse_sand +
            "[[study.s.stage]]\nname = \"initial\"\ndo = \"compact\"\npressure = \"100 kPa\"\n"
            "protocol = \"faithful\"\nvoid_ratio = 0.70\nrecord = { every = 50 }\n",
        folder.path()
    );
    const nlohmann::json numbers = stage_of(folder.path(), "initial");
    ASSERT_GT(numbers.at("steps_of_trials"), numbers.at("steps")); // what the test is about
    const std::vector<std::string> lines = lines_of(folder / "run/studies/s/initial/history.csv");
    EXPECT_EQ(std::stoll(lines.back()), numbers.at("steps").get<std::int64_t>());
    EXPECT_EQ(std::ssize(lines) - 1, numbers.at("steps").get<std::int64_t>() / 50);
    std::istringstream last(lines.back());
    std::string cell;
    for (int column = 0; column < 9; ++column) {
        std::getline(last, cell, ',');
    }
    EXPECT_DOUBLE_EQ(std::stod(cell), numbers.at("void_ratio"));
}

TEST(StageNumbers, TheMeanFluxThroughThroatsIsThatOfAGradientOfOneWhateverTheSign) {
    const TempFolder folder;
    run_text(
        reference_constants + coarse_sand +
            "[[study.s.stage]]\nname = \"plus\"\ndo = \"flow\"\ngradient = 0.1\n"
            "[[study.s.stage]]\nname = \"minus\"\ndo = \"flow\"\ngradient = -0.1\n",
        folder.path()
    );
    const auto mean_flux = [&](const std::string& stage) {
        return record::read_cbor(folder / ("run/studies/s/" + stage + "/results.cbor"))
            .at("throat_flux")
            .at("mean")
            .get<double>();
    };
    EXPECT_GT(mean_flux("plus"), 0);
    EXPECT_NEAR(mean_flux("minus"), mean_flux("plus"), 1e-6 * mean_flux("plus")); // of the solver
}

TEST(StageNumbers, TheRateOfAnErosionCountsTheGrainsThatWereThereInEachPass) {
    const TempFolder folder;
    run_text(
        reference_constants + reference_soil() + "[study.s]\nsoil = \"sand\"\nparticles = 500\n" + cloud_and_initial +
            "[[study.s.stage]]\nname = \"erosion\"\ndo = \"erode\"\npasses = 3\ngradient = 0.05\n"
            "forced = { max_contacts = 3 }\n",
        folder.path()
    );
    const nlohmann::json numbers = stage_of(folder.path(), "erosion");
    double made = 0, grains = 500;
    for (const nlohmann::json& pass : numbers.at("passes")) {
        const nlohmann::json& probe = pass.at("probe");
        const double probed = probe.at("relax_steps").get<double>() +
                              2 * (probe.at("ramp").get<double>() + probe.at("watch").get<double>());
        made += probed * grains;
        grains -= pass.at("removed").get<double>();
        made += pass.at("steps").get<double>() * grains;
    }
    ASSERT_LT(grains, 500);
    EXPECT_EQ(grains, numbers.at("grains"));
    const double reported =
        numbers.at("particle_steps_per_second").get<double>() * numbers.at("wall_seconds").get<double>();
    EXPECT_NEAR(reported, made, 1e-9 * made);
}

TEST(StageNumbers, AStressRatioThatIsPassedIsReportedAsARatioForTheDeviatorMayBeTheOneHeld) {
    const TempFolder folder;
    run_text(
        reference_constants + reference_soil() + study_of_packing("packing500") +
            "[[study.s.stage]]\nname = \"sheared\"\ndo = \"triaxial\"\nstress_ratio = 0.6\n"
            "[[study.s.stage]]\nname = \"held\"\ndo = \"triaxial\"\npath = \"constant-deviator\"\nstrain = \"1 %\"\n"
            "stress_ratio = 0.5\n",
        folder.path()
    );
    const std::string warnings = stage_of(folder.path(), "held").at("warnings").dump();
    EXPECT_NE(warnings.find("specified to stop at q/p = 0.5, the test started at 0.6"), std::string::npos) << warnings;
}

} // namespace
} // namespace suffuse::test
