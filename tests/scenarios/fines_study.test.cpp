// A study over the fines content, from the case to its numbers: the ends of the sweep, a wanted intergranular void
// ratio, fines taken out at once, and what the summary says of it all.

#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <algorithm>
#include <atomic>
#include <memory>

namespace suffuse::test {
namespace {

using nlohmann::json;

const std::string study = mixed_soil + R"(
[study.s]
soil        = "mixture"
sample_size = { coarse_grains = 60, cell_width = 10, at_least = 150 }
sweep       = { fines_content = ["0 %", "30 %", "100 %"] }
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.62
[[study.s.stage]]
name     = "loose"
do       = "compact"
pressure = "100 kPa"
protocol = "swift"
[[study.s.stage]]
name     = "emptied"
do       = "remove"
measure  = ["permeability", "constrictions", "coordination-of-eroded", "volumetric-strain", "grading", "porosity"]
only     = { fines_content = ["30 %"] }
[[study.s.stage]]
name                     = "asked"
from                     = "cloud"
do                       = "compact"
pressure                 = "100 kPa"
protocol                 = "swift"
intergranular_void_ratio = 1.15
void_ratio_tolerance     = 0.01
only                     = { fines_content = ["30 %"] }
)";

json stage_json(const TempFolder& folder, const std::string& place) {
    return record::read_json(folder / ("run/studies/s/" + place + "/stage.json"));
}

class FinesStudy : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TempFolder>();
        report_ = run_text(reference_constants + study, folder_->path());
    }

    static void TearDownTestSuite() { folder_.reset(); }

    static std::unique_ptr<TempFolder> folder_;
    static job::RunReport report_;
};

std::unique_ptr<TempFolder> FinesStudy::folder_;
job::RunReport FinesStudy::report_;

TEST_F(FinesStudy, ThePureSoilsHaveWhatTheDefinitionsSayAndNullWhereThereIsNothing) {
    ASSERT_TRUE(report_.failures.empty()) << report_.failures.front().message;
    const json sand = stage_json(*folder_, "fc=0/loose"), silt = stage_json(*folder_, "fc=100/loose");
    EXPECT_EQ(sand.at("fines_content"), 0);
    EXPECT_EQ(sand.at("intergranular_void_ratio"), sand.at("void_ratio"));
    EXPECT_EQ(sand.at("equivalent_void_ratio"), sand.at("void_ratio"));
    EXPECT_TRUE(sand.at("active_fines_fraction").is_null());
    EXPECT_EQ(sand.at("contact_share").at("LL"), 1);
    EXPECT_EQ(sand.at("alpha_coarse"), 1);
    EXPECT_EQ(silt.at("fines_content"), 1);
    EXPECT_TRUE(silt.at("intergranular_void_ratio").is_null()) << "infinite";
    EXPECT_EQ(silt.at("strong_contact_share").at("SS"), 1);
    EXPECT_TRUE(silt.at("coordination_by_class").at("coarse_fine").is_null());
}

TEST_F(FinesStudy, StressOfTheFractionsAddsUpToTheStress) {
    const json mix = stage_json(*folder_, "fc=30/loose");
    const double content = mix.at("fines_content");
    const double sum =
        content * mix.at("alpha_fines").get<double>() + (1 - content) * mix.at("alpha_coarse").get<double>();
    EXPECT_NEAR(sum, 1, 1e-12); // an identity: rounding
    EXPECT_NEAR(mix.at("fines_stress_share").get<double>(), content * mix.at("alpha_fines").get<double>(), 1e-12);
    EXPECT_GT(mix.at("fabric").at("contact_anisotropy"), 0);
    EXPECT_GT(mix.at("force_distribution").at("variation"), 0);
}

TEST_F(FinesStudy, AWantedIntergranularVoidRatioIsMet) {
    // The tolerance is on e; e_g = (e + FC)/(1 - FC) widens it.
    EXPECT_NEAR(stage_json(*folder_, "fc=30/asked").at("intergranular_void_ratio").get<double>(), 1.15, 0.01 / 0.68);
}

TEST_F(FinesStudy, RemovalLeavesTheCoarseGrainsUnderTheirStress) {
    const json before = stage_json(*folder_, "fc=30/loose"), after = stage_json(*folder_, "fc=30/emptied");
    EXPECT_EQ(after.at("grains").get<int>() + after.at("removed").get<int>(), before.at("grains").get<int>());
    EXPECT_EQ(after.at("fines_content"), 0);
    EXPECT_NEAR(after.at("removed_mass_share").get<double>(), before.at("fines_content").get<double>(), 1e-12);
    EXPECT_NEAR(after.at("mean_stress").get<double>(), 100e3, 0.005 * 100e3); // [balance] stress_error
    EXPECT_GT(after.at("stress_loss"), 0) << "fines carried some of it";
    EXPECT_GT(after.at("volumetric_strain"), 0);
    EXPECT_LT(after.at("stress_ratio_before"), 0.02);
    EXPECT_FALSE(after.at("failed"));
}

TEST_F(FinesStudy, AStageMeasuresWhatIsRequested) {
    const json stage = stage_json(*folder_, "fc=30/emptied"), measured = stage.at("measured");
    EXPECT_EQ(measured.size(), 6);
    EXPECT_EQ(measured.at("porosity").at("porosity"), stage.at("porosity"));
    EXPECT_EQ(measured.at("coordination-of-eroded").at("coordination_histogram"), stage.at("coordination_histogram"));
    const double strain = measured.at("volumetric-strain").at("volumetric_strain"),
                 reported = stage.at("volumetric_strain");
    EXPECT_NEAR(strain, reported, 0.5 * reported * reported + 1e-9); // logarithmic, unlike that of the removal
    const json water = measured.at("permeability"), tensor = water.at("tensor");
    double trace = 0;
    for (int a = 0; a < 3; ++a) {
        trace += tensor.at(a).at(a).get<double>();
    }
    EXPECT_DOUBLE_EQ(water.at("mean"), trace / 3);
    // Kozeny-Carman for spheres, k = d2 n3/(180 (1 - n)2), within a factor of two.
    const double n = stage.at("porosity"), d = measured.at("grading").at("d50");
    const double expected = d * d * n * n * n / (180 * (1 - n) * (1 - n));
    EXPECT_GT(trace / 3, 0.5 * expected);
    EXPECT_LT(trace / 3, 2 * expected);
    EXPECT_GE(d, 0.28e-3); // only coarse grains are left
    EXPECT_GT(measured.at("constrictions").at("count"), 0);
    EXPECT_LT(measured.at("constrictions").at("mean"), d);
    EXPECT_FALSE(stage_json(*folder_, "fc=30/loose").contains("measured"));
}

TEST_F(FinesStudy, TheSummaryJudgesWhatThreeFinesContentsCanDecide) {
    const json summary = record::read_json(*folder_ / "run/summary.json");
    std::vector<std::string> ids;
    for (const json& finding : summary.at("findings")) {
        ids.push_back(finding.at("id"));
        if (finding.at("id") == "M3" || finding.at("id") == "M9") {
            EXPECT_TRUE(finding.at("met").is_null()) << finding;
        }
    }
    EXPECT_EQ(ids, (std::vector<std::string>{"M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M9"}));
    EXPECT_EQ(summary.at("thresholds").at(0).at("name"), "FC_threshold");
}

TEST_F(FinesStudy, ARemovalThatIsStoppedEndsWithTheSameBits) {
    const TempFolder broken;
    std::atomic<bool> stop{false};
    run::RunOptions options;
    options.stop = &stop;
    options.progress_interval = 0;
    options.on_progress = [&](const run::Progress& progress) { // the stage before the removal: it meets the stop
        stop = stop || (progress.stage_finished && progress.stage == "loose" && progress.sample == 2);
    };
    EXPECT_EQ(run_text(reference_constants + study, broken.path(), options).outcome, record::Outcome::Stopped);
    EXPECT_FALSE(std::filesystem::exists(broken / "run/studies/s/fc=30/emptied/stage.json"));
    run_text(reference_constants + study, broken.path());
    EXPECT_EQ(
        stage_json(broken, "fc=30/emptied").at("state_hash"), stage_json(*folder_, "fc=30/emptied").at("state_hash")
    );
}

TEST(RemovalTwice, FromTwoStatesOfASampleIsShownWithGrainsThatAllStatesShownHave) {
    const std::string advance = "do = \"advance\"\nsteps = 50\nstrain_rate = [\"0 1/s\", \"0 1/s\", \"0 1/s\"]\n";
    const std::string remove = "do = \"remove\"\n";
    std::string text = reference_constants + mixed_soil +
                       "[study.s]\nsoil = \"mixture\"\nparticles = 300\nsweep = { fines_content = [\"30 %\"] }\n" +
                       cloud_and_initial;
    const auto add = [&](const std::string& name, const std::string& from, const std::string& verb) {
        text += "[[study.s.stage]]\nname = \"" + name + "\"\nfrom = \"" + from + "\"\n" + verb;
    };
    add("emptied", "initial", remove);
    add("after", "emptied", advance);
    add("moved", "initial", advance);
    add("emptied-moved", "moved", remove);
    add("after-moved", "emptied-moved", advance);
    const TempFolder folder;
    const job::RunReport report = run_text(text, folder.path());
    EXPECT_TRUE(report.failures.empty());
    EXPECT_TRUE(std::filesystem::exists(folder / "run/summary.json"));
}

} // namespace
} // namespace suffuse::test
