// Stages of several passes: an erosion that ends at a target, one by force, and stops between two passes.

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>

namespace suffuse::test {
namespace {

using nlohmann::json;
using std::filesystem::path;

std::string erosion(const std::string& name, const std::string& keys) {
    return "[[study.s.stage]]\nname = \"" + name +
           "\"\nfrom = \"settled\"\ndo = \"erode\"\nforced = { max_contacts = 2 }\nrelax_limit = 500\n" + keys;
}

std::string start() {
    return reference_constants + reference_soil() + study_of_packing("packing2000");
}

TEST(ErosionTarget, EndsTheStageWithThePassThatReachesIt) {
    const TempFolder folder;
    run_text(
        start() + erosion("little", "passes = 5\nuntil_eroded = { share = \"5 %\" }\n") +
            erosion("much", "passes = 1\nuntil_eroded = { share = \"90 %\", of = \"solids\" }\n"),
        folder.path()
    );
    const json little = stage_of(folder.path(), "little"), pass = little.at("passes").at(0);
    EXPECT_EQ(little.at("passes").size(), 1U);
    EXPECT_TRUE(pass.at("reached_target"));
    EXPECT_NE(pass.at("verdict").get<std::string>().find("5 % was specified"), std::string::npos);
    EXPECT_EQ(pass.at("ended").at("why"), "target reached");
    EXPECT_EQ(pass.at("ended").at("asked"), 0.05);
    EXPECT_EQ(little.at("warnings").dump().find("was specified"), std::string::npos)
        << "a target that is met is no warning";
    const double solids = little.at("eroded_share_of_solids"), fines = little.at("eroded_share_of_fines");
    EXPECT_GE(fines, 0.05);
    EXPECT_NEAR(100 * solids, pass.at("eroded_mass_percent_of_initial").get<double>(), 1e-9);
    // What has left and what is left are all the fines that there were.
    const double left = pass.at("fines_content_after").get<double>() * (1 - solids);
    EXPECT_NEAR(fines, solids / (solids + left), 1e-9);

    const json much = stage_of(folder.path(), "much");
    EXPECT_FALSE(much.at("passes").at(0).at("reached_target"));
    EXPECT_NE(much.at("warnings").dump().find("less than the 90 % of `until_eroded`"), std::string::npos);
}

TEST(ErosionTarget, IsReachedAlthoughTheSkeletonFailsInThatPassAndBothAreReported) {
    const TempFolder folder;
    const std::string few = "finer_than = \"0.29 mm\"", soil = reference_soil(); // leaves 13 coarse grains of 500
    run_text(
        reference_constants + std::string(soil).replace(soil.find("finer_than"), few.size(), few) +
            study_of_packing("packing500") + erosion("few", "passes = 3\nuntil_eroded = { share = \"0.1 %\" }\n"),
        folder.path()
    );
    const json stage = stage_of(folder.path(), "few");
    ASSERT_EQ(stage.at("passes").size(), 1U);
    const std::string verdict = stage.at("passes").at(0).at("verdict"), warnings = stage.at("warnings").dump();
    EXPECT_TRUE(stage.at("passes").at(0).at("reached_target"));
    EXPECT_NE(verdict.find("was specified; the coarse skeleton has 13 grains left"), std::string::npos) << verdict;
    EXPECT_NE(warnings.find("the coarse skeleton has 13 grains left"), std::string::npos) << warnings;
}

TEST(ErosionTarget, AnErosionFromWhichNothingLeavesAnyMoreHasEndedAndWarnsOfNothing) {
    const TempFolder folder;
    std::string rattlers = erosion("rattlers", "passes = 20\n");
    rattlers.replace(rattlers.find("max_contacts = 2"), 16, "max_contacts = 0");
    run_text(start() + rattlers, folder.path());
    const json stage = stage_of(folder.path(), "rattlers"), last = stage.at("passes").back();
    EXPECT_EQ(last.at("removed"), 0);
    EXPECT_EQ(last.at("verdict"), "nothing leaves any more");
    EXPECT_EQ(last.at("ended"), json({{"why", "nothing leaves"}}));
    EXPECT_EQ(stage.at("warnings").dump().find("nothing leaves"), std::string::npos);
}

TEST(ForcedErosion, GoesOnWhateverTheNoiseOfTheProbe) {
    const TempFolder folder;
    // So short a watch of a sample so little relaxed that grains speed up with the water as they do without.
    const std::string unrest = "relax_limit = 1\npasses = 2\ngradient = 1e-4\nramp = 1\nwatch = 10\n";
    const std::string erode = "\"\nfrom = \"settled\"\ndo = \"erode\"\n" + unrest;
    run_text(
        start() + "[[study.s.stage]]\nname = \"forced" + erode + "forced = { max_contacts = 2 }\n" +
            "[[study.s.stage]]\nname = \"probed" + erode,
        folder.path()
    );
    const auto first = [&](const std::string& stage) {
        return stage_of(folder.path(), stage).at("passes").at(0).at("ended");
    };
    EXPECT_EQ(first("probed"), json({{"why", "noise decides"}}));
    EXPECT_EQ(first("forced"), nullptr);
    EXPECT_EQ(stage_of(folder.path(), "forced").at("passes").size(), 2U);
}

TEST(ErosionReport, DescribesAllErosionsAndNamesTheOneItShows) {
    const TempFolder folder;
    std::string swept = start();
    const std::string study = "[study.s]\n";
    ASSERT_NE(swept.find(study), std::string::npos);
    swept.insert(swept.find(study) + study.size(), "sweep = { \"stage.forced.forced.max_contacts\" = [0, 2] }\n");
    run_text(swept + erosion("forced", "passes = 1\nwatch = 100\nramp = 100\n"), folder.path());
    const std::string page = text_of(folder.path() / "run/report.html");
    EXPECT_NE(page.find("All erosions"), std::string::npos);
    EXPECT_NE(page.find("2 erosions removed "), std::string::npos);
    EXPECT_NE(page.find("the following describes s, forced, max contacts 0"), std::string::npos);
}

/// Runs to the first sign that the stage has a pass behind it, stops, and goes on to the end.
void run_with_a_stop_between_passes(const std::string& text, const path& folder, const std::string& stage) {
    const path partial = folder / "run/studies/s" / stage / "partial.h5";
    std::atomic<bool> stop{false};
    run::RunOptions options;
    options.stop = &stop;
    options.progress_interval = 0;
    options.on_progress = [&](const run::Progress&) { stop = stop || std::filesystem::exists(partial); };
    ASSERT_EQ(run_text(text, folder, options).outcome, record::Outcome::Stopped);
    ASSERT_TRUE(std::filesystem::exists(partial));
    run_text(text, folder);
}

TEST(SeveralPasses, StoppedBetweenTwoLeaveTheSameStateHistoryLedgerAndWarnings) {
    for (const std::string& keys :
         {std::string("do = \"erode\"\nforced = { max_contacts = 2 }\nrelax_limit = 500\npasses = 2\n"),
          std::string("do = \"erode\"\npasses_constriction = { size = \"flow-path\", distance = \"0.1 mm\" }\n"
                      "ramp = 100\nwatch = 100\nrelax_limit = 20000\ngradient = 0.5\npasses = 2\n"),
          std::string("do = \"remove\"\nshare = \"60 %\"\norder = \"least-stressed\"\npasses = 3\n")}) {
        const std::string text = start() + "[[study.s.stage]]\nname = \"last\"\n" + keys;
        const TempFolder straight, broken;
        run_text(text, straight.path());
        run_with_a_stop_between_passes(text, broken.path(), "last");
        const json a = stage_of(straight.path(), "last"), b = stage_of(broken.path(), "last");
        EXPECT_GE(a.at("passes").size(), 2U) << keys;
        EXPECT_EQ(a.at("state_hash"), b.at("state_hash")) << keys;
        EXPECT_EQ(a.at("warnings"), b.at("warnings")) << keys;
        EXPECT_EQ(a.at("steps"), b.at("steps")) << keys;
        for (const char* file : {"history.csv", "eroded.csv", "transport.csv"}) {
            EXPECT_EQ(text_of(straight / "run/studies/s/last" / file), text_of(broken / "run/studies/s/last" / file))
                << keys;
        }
    }
}

} // namespace
} // namespace suffuse::test
