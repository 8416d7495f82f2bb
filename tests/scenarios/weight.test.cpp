// Fines that have weight, through the whole program: what a rising gradient moves, and what an erosion takes of it.

#include "suffuse/io/checkpoint.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>
#include <set>

namespace suffuse::test {
namespace {

using nlohmann::json;
using std::filesystem::path;

const std::string up = "[gravity]\ndown = \"-z\"\n";

std::string stage(const std::string& name, const std::string& keys) {
    return "[[study.s.stage]]\nname = \"" + name + "\"\nfrom = \"settled\"\n" + keys;
}

std::string start(const std::string& gravity, const std::string& packing = "packing500") {
    return reference_constants + gravity + reference_soil() + study_of_packing(packing);
}

TEST(Weight, ReportsTheGradientsOfASandThatBarelyMovesAndLeavesItUnchanged) {
    const TempFolder folder;
    run_text(
        start(up) + stage("upward", "do = \"detach\"\ngradients = [0.2, 0.6, 1.2]\nasked_gradient = 0.2\n"),
        folder.path()
    );
    const json reported = stage_of(folder.path(), "upward"), settled = stage_of(folder.path(), "settled");
    EXPECT_EQ(reported.at("model"), "with weight");
    EXPECT_EQ(reported.at("state_hash"), settled.at("state_hash"));
    EXPECT_EQ(reported.at("alpha_fines"), settled.at("alpha_fines"));
    const double heave = (1 - settled.at("porosity").get<double>()) * (2600 - 1000) / 1000;
    EXPECT_NEAR(reported.at("heave_gradient").get<double>(), heave, 1e-12);
    EXPECT_NEAR(
        reported.at("skempton_brogan_gradient").get<double>(), heave * reported.at("alpha_fines").get<double>(), 1e-12
    );
    double before = 0;
    for (const json& step : reported.at("mobility")) {
        const double mobile = step.at("mobile_mass_share"), leaving = step.at("leaving_mass_share");
        EXPECT_GE(mobile, before);
        EXPECT_LE(leaving, mobile);
        EXPECT_EQ(step.at("floats"), step.at("gradient").get<double>() >= heave);
        before = mobile;
        if (step.at("gradient") == 0.6) {
            EXPECT_LT(mobile, 0.05) << "its fines carry";
        }
    }
    EXPECT_NE(
        text_of(folder.path() / "run/studies/s/upward/mobility.csv").find("still_growing\n0.05,"), std::string::npos
    );
    EXPECT_NE(text_of(folder.path() / "run/studies/s/upward/grains.csv").find(",mobile_gradient\n"), std::string::npos);
    const std::string page = text_of(folder.path() / "run/report.html");
    EXPECT_NE(page.find("Upward flow moves"), std::string::npos);
    EXPECT_NE(page.find("own-mobility"), std::string::npos);
    EXPECT_NE(page.find("Internal stability by the simulated grading"), std::string::npos);
}

TEST(Weight, ARampThatIsStoppedGoesOnFromItsLastLevelToTheSameBits) {
    const TempFolder straight, broken;
    const std::string text = start(up) + stage("upward", "do = \"detach\"\ngradients = [0.2, 0.6, 1.2]\n");
    run_text(text, straight.path());
    std::set<std::string> stopped_in;
    for (int beats = 12; beats < 12 << 10; beats *= 2) { // more than a level takes, in the end
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int left = beats;
        options.on_progress = [&](const run::Progress& progress) {
            if (progress.stage == "upward") {
                EXPECT_TRUE(stopped_in.empty() || progress.part != "rest") << "it has rested";
                if (progress.part.starts_with("gradient") && --left == 0) {
                    stop = true;
                    stopped_in.insert(progress.part);
                }
            }
        };
        if (run_text(text, broken.path(), options).outcome != record::Outcome::Stopped) {
            break;
        }
    }
    EXPECT_GE(stopped_in.size(), 2U);
    const auto found = [](const TempFolder& folder) {
        return record::read_cbor(folder / "run/studies/s/upward/results.cbor").at("mobility");
    };
    EXPECT_EQ(nlohmann::json::to_cbor(found(broken)), nlohmann::json::to_cbor(found(straight))) << "not numbers, too";
    EXPECT_EQ(stage_of(broken.path(), "upward").at("state_hash"), stage_of(straight.path(), "upward").at("state_hash"));
}

TEST(Weight, DecidesWhatAnErosionTakesWhoseGradientRisesFromPassToPass) {
    const TempFolder folder;
    run_text(
        start(up, "packing2000") + stage(
                                       "rising", "do = \"erode\"\ngradient = [0.05, 0.5]\ndirection = \"x\"\n"
                                                 "passes_constriction = { size = \"none\" }\n"
                                   ),
        folder.path()
    );
    const json reported = stage_of(folder.path(), "rising"), passes = reported.at("passes");
    ASSERT_EQ(passes.size(), 2U) << "a pass from which nothing leaves is not the last where the gradient rises";
    EXPECT_LT(passes.at(0).at("removed").get<int>(), passes.at(1).at("removed").get<int>());
    for (const json& pass : passes) {
        EXPECT_EQ(pass.at("removed"), pass.at("detachable")) << "nothing holds a mobile grain back here";
        EXPECT_FALSE(pass.contains("probe"));
        EXPECT_TRUE(pass.at("heave_gradient").is_null()) << "level flow lifts nothing";
    }
    const std::string left = text_of(folder.path() / "run/studies/s/rising/eroded.csv");
    EXPECT_NE(left.find(",mobile\n"), std::string::npos) << left.substr(0, 200);
    EXPECT_NE(text_of(folder.path() / "run/studies/s/rising/mobility.csv").find(",pass\n"), std::string::npos);
}

TEST(Weight, ChangesNoBitWhereNoStageProbesMobility) {
    const TempFolder with, without;
    const std::string test = stage("flow", "do = \"flow\"\ngradient = 0.1\n");
    run_text(start(up) + test, with.path());
    run_text(start("") + test, without.path());
    for (const char* name : {"settled", "flow"}) {
        EXPECT_EQ(stage_of(with.path(), name).at("state_hash"), stage_of(without.path(), name).at("state_hash"));
    }
    EXPECT_EQ(stage_of(with.path(), "flow").at("permeability"), stage_of(without.path(), "flow").at("permeability"));
}

TEST(Weight, IsMissedInOneSentenceWhereFinesHaveNone) {
    const TempFolder folder;
    run_text(
        start("") + stage("probe", "do = \"detach\"\ngradients = [0.1]\nramp = 50\nwatch = 50\nrelax_limit = 100\n"),
        folder.path()
    );
    EXPECT_EQ(stage_of(folder.path(), "probe").at("model"), "weightless");
    EXPECT_NE(text_of(folder.path() / "run/report.html").find("Grains have no weight in this case"), std::string::npos);
}

} // namespace
} // namespace suffuse::test
