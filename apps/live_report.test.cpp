#include "apps/live_report.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"

namespace suffuse::apps {
namespace {

plan::RunPlan two_stages() {
    plan::RunPlan plan;
    for (const char* name : {"initial", "erosion"}) {
        plan::StageEstimate stage;
        stage.study = "dyke";
        stage.stage = name;
        stage.verb = "compact";
        stage.seconds = {10, 20};
        plan.stages.push_back(stage);
    }
    plan.stages.push_back(plan.stages.back());
    plan.stages.back().stage = "never"; // --until leaves it out
    plan.stages.back().seconds = {};
    return plan;
}

run::Progress at(const std::string& stage, bool finished, double void_ratio) {
    run::Progress progress;
    progress.study = "dyke";
    progress.stage = stage;
    progress.stages = 2;
    progress.stages_done = finished ? 1 : 0;
    progress.stage_seconds = 3.25;
    progress.stage_finished = finished;
    progress.state = {{"void_ratio", void_ratio}};
    return progress;
}

TEST(LiveReport, IsThereFromTheStartAndShowsWhatIsDoneAndWhatWaits) {
    const test::TempFolder folder;
    LiveReport live(folder.path(), "Dyke", "suffuse resume x", two_stages());
    std::string page = test::read_all(folder / "report.html");
    EXPECT_NE(page.find("http-equiv=\"refresh\""), std::string::npos);
    EXPECT_NE(page.find("0 of 2 stages"), std::string::npos);
    EXPECT_NE(page.find("10-20 s by the plan"), std::string::npos);
    EXPECT_EQ(page.find("never"), std::string::npos);
    live.show(at("initial", true, 0.686));
    page = test::read_all(folder / "report.html");
    EXPECT_NE(page.find("1 of 2 stages"), std::string::npos);
    EXPECT_NE(page.find("<td class=\"status\">done</td><td>3.2 s</td><td>e 0.686</td>"), std::string::npos) << page;
}

TEST(LiveReport, IsWrittenOncePerIntervalAndAtTheEnd) {
    const test::TempFolder folder, often;
    LiveReport live(folder.path(), "Dyke", "suffuse resume x", two_stages(), std::chrono::hours(1));
    LiveReport hasty(often.path(), "Dyke", "suffuse resume x", two_stages(), std::chrono::hours(0));
    for (const double void_ratio : {0.7, 0.6}) {
        live.show(at("initial", false, void_ratio));
        hasty.show(at("initial", false, void_ratio));
    }
    EXPECT_NE(test::read_all(often / "report.html").find("e 0.6"), std::string::npos);
    EXPECT_EQ(test::read_all(folder / "report.html").find("e 0.6"), std::string::npos);
    live.close("The run ended early: stopped.");
    const std::string page = test::read_all(folder / "report.html");
    EXPECT_NE(page.find("e 0.6"), std::string::npos); // the last page has the last state
    EXPECT_EQ(page.find("http-equiv=\"refresh\""), std::string::npos);
    EXPECT_NE(page.find("<code>suffuse resume x</code>"), std::string::npos);
}

TEST(LiveReport, ASampleThatWasDoneBeforeDoesNotRun) {
    const test::TempFolder folder;
    LiveReport live(folder.path(), "Dyke", "suffuse resume x", two_stages());
    run::Progress ended = at("erosion", false, 0.7);
    ended.stage_seconds = 0;
    ended.sample_ended = true;
    live.show(ended);
    EXPECT_EQ(test::read_all(folder / "report.html").find("<td class=\"status\">running"), std::string::npos);
    live.show(at("initial", true, 0.7));
    live.show(ended);
    live.close("over");
    EXPECT_NE(test::read_all(folder / "report.html").find(">done</td><td>3.2 s</td>"), std::string::npos);
}

TEST(LiveReport, AFolderThatCannotBeWrittenStopsNothing) {
    EXPECT_NO_THROW({
        LiveReport live("/dev/null/nowhere", "", "", two_stages());
        live.show(at("initial", true, 0.7));
        live.close("x");
    });
}

} // namespace
} // namespace suffuse::apps
