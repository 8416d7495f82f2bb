// What watch reads: the published progress, and the events as they come.

#include "suffuse/job/run_folder.hpp"

#include <gtest/gtest.h>

#include "apps/console.hpp"
#include "apps/event_log.hpp"
#include "apps/progress_file.hpp"
#include "tests/support/temp_folder.hpp"
#include <cerrno>
#include <fstream>
#include <sys/file.h>

namespace suffuse::apps {
namespace {

using test::TempFolder;

run::Progress somewhere(int sample) {
    run::Progress progress;
    progress.study = "sweep/fc=" + std::to_string(sample);
    progress.stage = "shear";
    progress.verb = "triaxial";
    progress.part = "shear";
    progress.sample = sample;
    progress.samples = 2;
    progress.stage_number = sample;
    progress.stages = 2;
    progress.steps = 1200;
    progress.particle_steps_per_second = 2e7;
    progress.state = {{"void_ratio", 0.67}};
    return progress;
}

TEST(ProgressFile, SaysWhereEachSampleIsAndHowLongItWillTake) {
    const TempFolder folder;
    plan::RunPlan plan;
    plan.stages.resize(2);
    plan.stages[0].seconds = plan.stages[1].seconds = {100, 200};
    ProgressFile file(folder.path(), plan);
    EXPECT_FALSE(read_progress(folder.path()).has_value());
    file.show(somewhere(1));
    run::Progress end = somewhere(2);
    end.stage_finished = true; // written at once, whatever the clock says
    file.show(end);
    const auto published = read_progress(folder.path());
    ASSERT_TRUE(published.has_value());
    EXPECT_EQ(published->running.size(), 2U);
    EXPECT_EQ(published->running.at(1).study, "sweep/fc=1");
    EXPECT_EQ(published->running.at(1).steps, 1200);
    EXPECT_EQ(published->running.at(1).state.at("void_ratio"), 0.67);
    EXPECT_EQ(published->latest.stage_number, 0); // what nobody shows is not published
    EXPECT_GT(published->left.most, 0);
    end.sample_ended = true;
    file.show(end);
    EXPECT_EQ(read_progress(folder.path())->running.size(), 1U);
}

TEST(ProgressFile, WhatCannotBeUnderstoodIsNothing) {
    const TempFolder folder;
    for (const std::string text : {"", "{", "[]", "{\"latest\": 1, \"running\": [], \"seconds_left\": [0, 1]}"}) {
        std::ofstream(folder / progress_file) << text;
        EXPECT_FALSE(read_progress(folder.path()).has_value()) << text;
    }
}

TEST(EventLog, GivesEachEventOnceAndWaitsForTheEndOfALine) {
    const TempFolder folder;
    EventLog log(folder.path());
    EXPECT_TRUE(log.read_new().empty());
    std::ofstream file(folder / "events.jsonl");
    file << R"({"at":"2026-11-21T10:26:59Z","event":"run begins"})" << '\n' << R"({"event":"stage)" << std::flush;
    ASSERT_EQ(log.read_new().size(), 1U);
    EXPECT_TRUE(log.read_new().empty());
    file << R"( done","stage":"replay/start","wall_seconds":0.25})"
         << "\nnot json\n"
         << std::flush;
    const auto events = log.read_new();
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(event_line(events[0]), "  stage done        replay/start, 0.2 s");
    EXPECT_TRUE(log.read_new().empty());
    EXPECT_EQ(event_line({{"event", "run begins"}}), "  run begins");
    EXPECT_EQ(
        event_line({{"event", "run ends"}, {"outcome", "stopped"}, {"wall_seconds", 3.0}}),
        "  run ends          stopped, 3.0 s"
    );
}

TEST(EventLog, HostileWordsDoNotMoveTheCursor) {
    const std::string line = event_line({{"event", "stage fails"}, {"what", "a\x1b[2Jb"}});
    EXPECT_EQ(line.find('\x1b'), std::string::npos);
}

TEST(RunFolder, KnowsWhetherSomebodyIsAtWork) {
    const TempFolder folder;
    EXPECT_FALSE(job::is_at_work(folder.path()));
    {
        const job::FolderLock lock(folder.path(), Console().warner());
        EXPECT_TRUE(job::is_at_work(folder.path()));
    }
    EXPECT_FALSE(job::is_at_work(folder.path()));
    EXPECT_EQ(job::try_lock(-1, LOCK_EX), EBADF);                   // cannot be locked: not the same as taken
    const job::FolderLock again(folder.path(), Console().warner()); // looking at it does not hold it
}

} // namespace
} // namespace suffuse::apps
